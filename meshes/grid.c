// meshes/grid.c
#include "meshes/grid.h"

#include "base/memory.h"
#include "meshes/outline.h"
#include "meshes/polygon.h"

#include <math.h>
#include <stdlib.h>

#define PI 3.14159265358979323846

// more cells than this come from a drawing that a free mesh follows with fewer elements
enum { MOST_CELLS = 4000 };

void grid_free(grid *g)
{
    free(g->at[0]);
    free(g->at[1]);
    free(g->owner);
    *g = (grid){0};
}

void grid_point(const grid *g, double a, double b, double *xy)
{
    if (g->polar) {
        xy[0] = g->centre[0] + a * cos(g->angle + b);
        xy[1] = g->centre[1] + a * sin(g->angle + b);
        return;
    }
    const double c = cos(g->angle), s = sin(g->angle);
    xy[0] = c * a - s * b;
    xy[1] = s * a + c * b;
}

static bool is_round(shape_kind kind)
{
    return kind == KIND_ANNULUS || kind == KIND_SECTOR || kind == KIND_DISC;
}

// all rings about one centre; the angles start at an edge of the last sector, so that a turn of the
// pattern turns the grid
static bool find_polar(const section_outline *o, grid *g)
{
    g->polar = true;
    for (int d = 0; d < 2; d++) {
        g->centre[d] = o->items[0].centre[d];
    }
    for (int k = 0; k < o->count; k++) {
        const outline *p = &o->items[k];
        const double off = hypot(p->centre[0] - g->centre[0], p->centre[1] - g->centre[1]);
        if (!is_round(p->kind) || off > OUTLINE_MERGE * o->size) {
            return false;
        }
        if (p->kind == KIND_SECTOR) {
            g->angle = p->mid_angle - p->width / 2;
        }
    }
    return true;
}

// whether the direction (dx, dy) runs along an axis of the grid
static bool along_axis(const grid *g, double dx, double dy)
{
    const double c = cos(g->angle), s = sin(g->angle);
    const double u = fabs(c * dx + s * dy), v = fabs(c * dy - s * dx);
    return fmin(u, v) <= OUTLINE_MERGE * fmax(u, v);
}

static bool loops_along_axes(const grid *g, const outline *o)
{
    for (int k = 0; k < o->nloop; k++) {
        const loop a = outline_loop(o, k);
        for (int i = 0; i < a.n; i++) {
            const double *p = a.p + 2 * i, *q = a.p + 2 * ((i + 1) % a.n);
            if (!along_axis(g, q[0] - p[0], q[1] - p[1])) {
                return false;
            }
        }
    }
    return true;
}

// rectangles and rectangular polygons, all turned alike up to right angles
static bool find_cartesian(const section_outline *o, grid *g)
{
    const outline *last = &o->items[o->count - 1];
    g->angle = last->angle;
    if (last->kind == KIND_POLYGON) {
        g->angle = atan2(last->point[3] - last->point[1], last->point[2] - last->point[0]);
        // the edge may be any of the four sides: the axis nearest to the polygon's own
        g->angle = last->angle + remainder(g->angle - last->angle, PI / 2);
    }
    for (int k = 0; k < o->count; k++) {
        const outline *p = &o->items[k];
        const bool fits = p->kind == KIND_RECTANGLE
                              ? along_axis(g, cos(p->angle), sin(p->angle))
                              : p->kind == KIND_POLYGON && loops_along_axes(g, p);
        if (!fits) {
            return false;
        }
    }
    return true;
}

typedef struct breaks {
    int n[2];
    double *at[2];
} breaks;

static void put(breaks *b, int direction, double value)
{
    b->at[direction][b->n[direction]++] = value;
}

static void put_point(breaks *b, const grid *g, const double *x)
{
    const double c = cos(g->angle), s = sin(g->angle);
    put(b, 0, c * x[0] + s * x[1]);
    put(b, 1, c * x[1] - s * x[0]);
}

// an angle counted from the grid's first edge, in [0, 2 pi)
static double from_edge(const grid *g, double angle)
{
    const double a = fmod(angle - g->angle, 2 * PI);
    return a < 0 ? a + 2 * PI : a;
}

static void put_shape(breaks *b, const grid *g, const outline *p)
{
    if (g->polar) {
        put(b, 0, p->inner);
        put(b, 0, p->outer);
        if (p->kind == KIND_SECTOR) {
            put(b, 1, from_edge(g, p->mid_angle - p->width / 2));
            put(b, 1, from_edge(g, p->mid_angle + p->width / 2));
        }
    } else if (p->kind == KIND_RECTANGLE) {
        double corner[4][2];
        rectangle_corners(p, corner);
        for (int i = 0; i < 4; i++) {
            put_point(b, g, corner[i]);
        }
    } else {
        for (int i = 0; i < p->loop_start[p->nloop]; i++) {
            put_point(b, g, p->point + 2 * i);
        }
    }
}

static int ascending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

// sorted and merged; *n becomes the number of different values
static void merge(int *n, double *at, double tolerance)
{
    qsort(at, (size_t)*n, sizeof *at, ascending);
    int kept = 0;
    for (int i = 0; i < *n; i++) {
        if (kept == 0 || at[i] - at[kept - 1] > tolerance) {
            at[kept++] = at[i];
        }
    }
    *n = kept;
}

// angles: what lies within the tolerance of 0 or 2 pi is the first edge itself
static void close_circle(breaks *b, double tolerance)
{
    double *at = b->at[1];
    for (int i = 0; i < b->n[1]; i++) {
        at[i] = at[i] <= tolerance || at[i] >= 2 * PI - tolerance ? 0 : at[i];
    }
    put(b, 1, 0);
    put(b, 1, 2 * PI);
}

static bool has_sliver(int n, const double *at, double thinnest)
{
    for (int i = 0; i < n; i++) {
        if (at[i + 1] - at[i] < thinnest) {
            return true;
        }
    }
    return false;
}

static status collect(const section_outline *o, const grid *g, breaks *b)
{
    status st = OK;
    size_t most = 4;
    for (int k = 0; k < o->count; k++) {
        const outline *p = &o->items[k];
        most += p->kind == KIND_POLYGON ? (size_t)p->loop_start[p->nloop] : 4;
    }
    TRY(TAKE(b->at[0], most));
    TRY(TAKE(b->at[1], most));
    for (int k = 0; k < o->count; k++) {
        put_shape(b, g, &o->items[k]);
    }

done:
    return st;
}

static void paint(const section_outline *o, grid *g)
{
    for (int j = 0; j < g->n[1]; j++) {
        for (int i = 0; i < g->n[0]; i++) {
            double x[2];
            grid_point(g, (g->at[0][i] + g->at[0][i + 1]) / 2, (g->at[1][j] + g->at[1][j + 1]) / 2,
                       x);
            const int top = section_top_shape(o, x[0], x[1]);
            g->owner[j * g->n[0] + i] = top >= 0 && o->items[top].material >= 0 ? top : -1;
        }
    }
}

static bool reaches_centre(const grid *g)
{
    for (int j = 0; g->polar && g->at[0][0] == 0 && j < g->n[1]; j++) {
        if (g->owner[j * g->n[0]] >= 0) {
            return true;
        }
    }
    return false;
}

status grid_make(const section_outline *o, grid *out, bool *found)
{
    status st = OK;
    grid g = {0};
    breaks b = {0};
    double unit[2] = {o->size, o->size};

    *found = false;
    *out = g;
    if (!find_polar(o, &g)) {
        g = (grid){0};
        if (!find_cartesian(o, &g)) {
            goto done;
        }
    }
    TRY(collect(o, &g, &b));
    if (g.polar) {
        unit[1] = 1; // an angle is an arc of that part of the section's size, or less
        close_circle(&b, OUTLINE_MERGE);
    }
    for (int d = 0; d < 2; d++) {
        merge(&b.n[d], b.at[d], OUTLINE_MERGE * unit[d]);
        g.n[d] = b.n[d] - 1;
        if (g.n[d] < 1 || has_sliver(g.n[d], b.at[d], OUTLINE_SLIVER * unit[d])) {
            goto done;
        }
    }
    if ((double)g.n[0] * g.n[1] > MOST_CELLS) {
        goto done;
    }
    for (int d = 0; d < 2; d++) {
        g.at[d] = b.at[d];
        b.at[d] = NULL;
    }
    TRY(TAKE(g.owner, (size_t)g.n[0] * (size_t)g.n[1]));
    paint(o, &g);
    if (!reaches_centre(&g)) {
        *found = true;
        *out = g;
        g = (grid){0};
    }

done:
    free(b.at[0]);
    free(b.at[1]);
    grid_free(&g);
    return st;
}
