// meshes/outline_turn.c
#include "meshes/outline_turn.h"

#include "meshes/loops.h"
#include "meshes/outline.h"
#include "meshes/polygon.h"

#include <math.h>

#define PI 3.14159265358979323846

static int last_of(const section_outline *o, bool sectors)
{
    int k = o->count - 1;
    while (k >= 0) {
        if (sectors ? o->items[k].kind == KIND_SECTOR : o->items[k].declares) {
            break;
        }
        k--;
    }
    return k;
}

double section_declared_turn(const section_outline *o)
{
    const int sector = last_of(o, true);
    if (sector >= 0) {
        return o->items[sector].mid_angle;
    }
    const int turned = last_of(o, false);
    return turned >= 0 ? o->items[turned].angle : 0;
}

// x -> point + (cos -sin; sin cos) diag(1, flip) (x - point) with the given angle: a turn (flip 1),
// or a mirror (flip -1) in the line through `point` at angle / 2
typedef struct motion {
    double point[2], angle;
    int flip;
    double gap; // two places nearer than this are one [m]
} motion;

static void moved(const motion *m, const double *x, double *y)
{
    const double c = cos(m->angle), s = sin(m->angle);
    const double dx = x[0] - m->point[0], dy = m->flip * (x[1] - m->point[1]);
    y[0] = m->point[0] + c * dx - s * dy;
    y[1] = m->point[1] + s * dx + c * dy;
}

static bool lands_on(const motion *m, const double *from, const double *to)
{
    double y[2];
    moved(m, from, y);
    return hypot(y[0] - to[0], y[1] - to[1]) <= m->gap;
}

// corner i of a lands on corner start + step i of b for some start; a mirror runs backwards
static bool loop_lands_on(const motion *m, loop a, loop b)
{
    if (a.n != b.n) {
        return false;
    }
    for (int start = 0; start < b.n; start++) {
        int i = 0;
        while (i < a.n) {
            const int j = ((start + m->flip * i) % b.n + b.n) % b.n;
            if (!lands_on(m, a.p + 2 * i, b.p + 2 * j)) {
                break;
            }
            i++;
        }
        if (i == a.n) {
            return true;
        }
    }
    return false;
}

// three points tell two arcs of one kind apart, four two cubics
static bool piece_lands_on(const motion *m, const carrier *a, const carrier *b)
{
    enum { POINTS = 4 };
    if (a->kind != b->kind) {
        return false;
    }
    for (int i = 0; i < POINTS; i++) {
        const double part = i / (POINTS - 1.0);
        double x[2], y[2];
        carrier_point(a, a->from + (a->to - a->from) * part, x);
        carrier_point(b, b->from + (b->to - b->from) * part, y);
        if (!lands_on(m, x, y)) {
            return false;
        }
    }
    return true;
}

static bool curves_land_on(const motion *m, curve_loop a, curve_loop b)
{
    if (a.n != b.n) {
        return false;
    }
    for (int start = 0; start < b.n; start++) {
        int i = 0;
        while (i < a.n) {
            const carrier *p = &b.piece[((start + m->flip * i) % b.n + b.n) % b.n];
            const carrier there = m->flip < 0 ? carrier_reversed(p) : *p;
            if (!piece_lands_on(m, &a.piece[i], &there)) {
                break;
            }
            i++;
        }
        if (i == a.n) {
            return true;
        }
    }
    return false;
}

static bool one_lands_on(const motion *m, const outline *a, int k, const outline *b, int j)
{
    return a->kind == KIND_LOOPS ? curves_land_on(m, outline_curves(a, k), outline_curves(b, j))
                                 : loop_lands_on(m, outline_loop(a, k), outline_loop(b, j));
}

static bool loops_land_on(const motion *m, const outline *a, const outline *b)
{
    if (a->nloop != b->nloop) {
        return false;
    }
    for (int k = 0; k < a->nloop; k++) {
        int j = 0;
        while (j < b->nloop && !one_lands_on(m, a, k, b, j)) {
            j++;
        }
        if (j == b->nloop) {
            return false;
        }
    }
    return true;
}

static bool shape_lands_on(const motion *m, const outline *a, const outline *b)
{
    if (a->kind != b->kind || a->material != b->material) {
        return false;
    }
    if (a->nloop > 0) {
        return loops_land_on(m, a, b);
    }
    if (!lands_on(m, a->centre, b->centre)) {
        return false;
    }
    if (a->kind == KIND_RECTANGLE) {
        const double reach = hypot(a->size[0], a->size[1]);
        const double turn = remainder(m->angle + m->flip * a->angle - b->angle, PI);
        return fabs(a->size[0] - b->size[0]) <= m->gap && fabs(a->size[1] - b->size[1]) <= m->gap &&
               fabs(turn) * reach <= m->gap;
    }
    if (fabs(a->outer - b->outer) > m->gap || fabs(a->inner - b->inner) > m->gap) {
        return false;
    }
    const double turn = angle_fold(m->angle + m->flip * a->mid_angle - b->mid_angle);
    return a->kind != KIND_SECTOR ||
           (fabs(turn) * a->outer <= m->gap && fabs(a->width - b->width) * a->outer <= m->gap);
}

// A partner other than the shape itself may lie elsewhere in the list: the shapes between must not
// tell the two apart.
static bool has_mirror_image(const motion *m, const section_outline *o, int k)
{
    if (shape_lands_on(m, &o->items[k], &o->items[k])) {
        return true;
    }
    for (int step = -1; step <= 1; step += 2) {
        for (int j = k + step; j >= 0 && j < o->count; j += step) {
            if (o->items[j].material != o->items[k].material) {
                break;
            }
            if (shape_lands_on(m, &o->items[k], &o->items[j])) {
                return true;
            }
        }
    }
    return false;
}

bool section_is_symmetric(const section_outline *o)
{
    const int sector = last_of(o, true);
    if (sector < 0) {
        return false;
    }
    const outline *s = &o->items[sector];
    const motion mirror = {.point = {s->centre[0], s->centre[1]},
                           .angle = 2 * s->mid_angle,
                           .flip = -1,
                           .gap = OUTLINE_MERGE * o->size};
    for (int k = 0; k < o->count; k++) {
        if (!has_mirror_image(&mirror, o, k)) {
            return false;
        }
    }
    return true;
}

bool section_outline_is_turned(const section_outline *a, const section_outline *b, double tolerance,
                               double *angle)
{
    *angle = b->turn - a->turn;
    if (a->count != b->count) {
        return false;
    }
    const motion turn = {.angle = *angle, .flip = 1, .gap = tolerance * a->size};
    for (int k = 0; k < a->count; k++) {
        if (!shape_lands_on(&turn, &a->items[k], &b->items[k])) {
            return false;
        }
    }
    return true;
}
