// meshes/outline.c
#include "meshes/outline.h"

#include "meshes/loops.h"
#include "meshes/polygon.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>

#define PI 3.14159265358979323846

status outline_fail(const outline *o, const char *format, ...)
{
    char words[512];
    va_list args;
    va_start(args, format);
    (void)vsnprintf(words, sizeof words, format, args);
    va_end(args);
    return status_fail_at(ERR_INPUT, o->at.line, o->at.column, "%s: %s", o->called, words);
}

double angle_fold(double angle)
{
    return remainder(angle, 2 * PI);
}

void rectangle_corners(const outline *o, double corner[4][2])
{
    const double c = cos(o->angle), s = sin(o->angle);
    const double sign[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    for (int i = 0; i < 4; i++) {
        const double x = sign[i][0] * o->size[0] / 2, y = sign[i][1] * o->size[1] / 2;
        corner[i][0] = o->centre[0] + c * x - s * y;
        corner[i][1] = o->centre[1] + s * x + c * y;
    }
}

static bool ring_contains(const outline *o, double x, double y)
{
    const double dx = x - o->centre[0], dy = y - o->centre[1], r = hypot(dx, dy);
    if (r > o->outer || r < o->inner) {
        return false;
    }
    return o->kind != KIND_SECTOR || fabs(angle_fold(atan2(dy, dx) - o->mid_angle)) <= o->width / 2;
}

bool outline_contains(const outline *o, double x, double y)
{
    const double dx = x - o->centre[0], dy = y - o->centre[1];
    switch (o->kind) {
    case KIND_ANNULUS:
    case KIND_SECTOR:
    case KIND_DISC:
        return ring_contains(o, x, y);
    case KIND_RECTANGLE: {
        const double c = cos(o->angle), s = sin(o->angle);
        return fabs(c * dx + s * dy) <= o->size[0] / 2 && fabs(c * dy - s * dx) <= o->size[1] / 2;
    }
    case KIND_POLYGON: {
        bool inside = false;
        for (int k = 0; k < o->nloop; k++) {
            inside ^= loop_contains(outline_loop(o, k), x, y);
        }
        return inside;
    }
    case KIND_LOOPS: {
        bool inside = false;
        for (int k = 0; k < o->nloop; k++) {
            inside ^= curves_contain(outline_curves(o, k), x, y);
        }
        return inside;
    }
    case KIND_COUNT:
        break;
    }
    return false;
}

int section_top_shape(const section_outline *o, double x, double y)
{
    int k = o->count - 1;
    while (k >= 0 && !outline_contains(&o->items[k], x, y)) {
        k--;
    }
    return k;
}

double outline_reach(const outline *o)
{
    double reach = 0;
    if (o->kind == KIND_POLYGON) {
        for (int i = 0; i < o->loop_start[1]; i++) {
            reach = fmax(reach, hypot(o->point[2 * i], o->point[2 * i + 1]));
        }
        return reach;
    }
    if (o->kind == KIND_RECTANGLE) {
        double corner[4][2];
        rectangle_corners(o, corner);
        for (int i = 0; i < 4; i++) {
            reach = fmax(reach, hypot(corner[i][0], corner[i][1]));
        }
        return reach;
    }
    if (o->kind == KIND_LOOPS) {
        return curves_reach(outline_curves(o, 0));
    }
    return hypot(o->centre[0], o->centre[1]) + o->outer;
}

static double thickness(const outline *o)
{
    const double wall = o->outer - o->inner, hole = o->inner > 0 ? o->inner : o->outer;
    switch (o->kind) {
    case KIND_ANNULUS:
        return fmin(wall, hole);
    case KIND_SECTOR:
        return fmin(fmin(wall, hole), o->outer * fmin(o->width, 2 * PI - o->width));
    case KIND_DISC:
        return o->outer;
    case KIND_RECTANGLE:
        return fmin(o->size[0], o->size[1]);
    case KIND_LOOPS:
        return o->thickness;
    default:
        return INFINITY; // a polygon's edges were compared with one another
    }
}

int section_thinnest_shape(const section_outline *o, double *part)
{
    int thinnest = -1;
    *part = INFINITY;
    for (int k = 0; k < o->count; k++) {
        const double own = thickness(&o->items[k]) / o->size;
        if (own < *part) {
            *part = own;
            thinnest = k;
        }
    }
    return thinnest;
}
