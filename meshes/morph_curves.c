#include "meshes/morph_curves.h"

#include "base/memory.h"
#include "meshes/outline.h"

#include <math.h>

#define PI 3.14159265358979323846

// tangents that differ by less [rad] make no corner: the drawing's own rounding
static const double SHARP = 1e-6;

void shape_curves_free(shape_curves *c)
{
    free(c->curve);
    free(c->piece);
    *c = (shape_curves){0};
}

static void begin(shape_curves *c, int shape)
{
    c->curve[c->ncurve++] = (shape_curve){.shape = shape, .first = c->npiece};
}

static void put(shape_curves *c, carrier piece)
{
    c->piece[c->npiece++] = piece;
    c->curve[c->ncurve - 1].n++;
}

static void put_ring(shape_curves *c, const outline *o, int shape, double turn)
{
    const double radius[2] = {o->outer, o->inner};
    for (int k = 0; k < 2; k++) {
        if (radius[k] > 0) {
            begin(c, shape);
            put(c, carrier_arc(o->centre, radius[k], radius[k], turn, 0, 2 * PI));
        }
    }
}

static void put_sector(shape_curves *c, const outline *o, int shape)
{
    const double from = o->mid_angle - o->width / 2, half = o->width / 2;
    const carrier outer = carrier_arc(o->centre, o->outer, o->outer, from + half, -half, half);
    double a[2], b[2], p[2] = {o->centre[0], o->centre[1]}, q[2] = {p[0], p[1]};
    carrier_start(&outer, a);
    carrier_end(&outer, b);
    begin(c, shape);
    put(c, outer);
    if (o->inner > 0) {
        const carrier inner = carrier_arc(o->centre, o->inner, o->inner, from + half, half, -half);
        carrier_start(&inner, p);
        carrier_end(&inner, q);
        put(c, carrier_line(b, p));
        put(c, inner);
    } else {
        put(c, carrier_line(b, p));
    }
    put(c, carrier_line(q, a));
}

static void put_corners(shape_curves *c, int shape, int n, const double *corner)
{
    begin(c, shape);
    for (int i = 0; i < n; i++) {
        put(c, carrier_line(corner + 2 * i, corner + 2 * ((i + 1) % n)));
    }
}

static void put_shape(shape_curves *c, const outline *o, int shape, double turn)
{
    double corner[4][2];
    switch (o->kind) {
    case KIND_ANNULUS:
    case KIND_DISC:
        put_ring(c, o, shape, turn);
        return;
    case KIND_SECTOR:
        put_sector(c, o, shape);
        return;
    case KIND_RECTANGLE:
        rectangle_corners(o, corner);
        put_corners(c, shape, 4, corner[0]);
        return;
    default:
        break;
    }
    for (int k = 0; k < o->nloop; k++) {
        const int first = o->loop_start[k], n = o->loop_start[k + 1] - first;
        if (o->kind == KIND_POLYGON) {
            put_corners(c, shape, n, o->point + 2 * first);
            continue;
        }
        begin(c, shape);
        for (int i = 0; i < n; i++) {
            put(c, o->piece[first + i]);
        }
    }
}

status shape_curves_make(const section_outline *o, double turn, shape_curves *out)
{
    status st = OK;
    shape_curves c = {0};
    size_t ncurve = 0, npiece = 0;
    for (int k = 0; k < o->count; k++) {
        const outline *p = &o->items[k];
        ncurve += p->nloop > 0 ? (size_t)p->nloop : 2;
        npiece += p->nloop > 0 ? (size_t)p->loop_start[p->nloop] : 4;
    }
    TRY(TAKE(c.curve, ncurve));
    TRY(TAKE(c.piece, npiece));
    for (int k = 0; k < o->count; k++) {
        put_shape(&c, &o->items[k], k, turn);
    }
    *out = c;
    c = (shape_curves){0};

done:
    shape_curves_free(&c);
    return st;
}

// the piece at a place, and the carrier's own parameter there
static const carrier *piece_at(const shape_curves *c, int curve, double place, double *t)
{
    const shape_curve *s = &c->curve[curve];
    const double around = place - s->n * floor(place / s->n);
    const int k = (int)fmin(floor(around), s->n - 1);
    const carrier *p = &c->piece[s->first + k];
    *t = p->from + (p->to - p->from) * (around - k);
    return p;
}

void shape_curve_point(const shape_curves *c, int curve, double place, double x[2])
{
    double t;
    const carrier *p = piece_at(c, curve, place, &t);
    carrier_point(p, t, x);
}

void shape_curve_slope(const shape_curves *c, int curve, double place, double dx[2])
{
    double t;
    const carrier *p = piece_at(c, curve, place, &t);
    carrier_slope(p, t, dx);
    dx[0] *= p->to - p->from;
    dx[1] *= p->to - p->from;
}

// nearest place of one piece, from 0 to 1
static double nearest_on_piece(const carrier *p, const double x[2], double *part)
{
    double t, at[2];
    (void)carrier_distance(p, x, &t);
    if (p->kind == CARRIER_ELLIPSE) {
        const double middle = (p->from + p->to) / 2;
        t = middle + remainder(t - middle, 2 * PI);
    }
    *part = fmin(fmax((t - p->from) / (p->to - p->from), 0), 1);
    carrier_point(p, p->from + (p->to - p->from) * *part, at);
    return hypot(at[0] - x[0], at[1] - x[1]);
}

double shape_curve_nearest(const shape_curves *c, int curve, const double x[2], double *place)
{
    const shape_curve *s = &c->curve[curve];
    double best = INFINITY;
    for (int k = 0; k < s->n; k++) {
        double part;
        const double away = nearest_on_piece(&c->piece[s->first + k], x, &part);
        if (away < best) {
            best = away;
            *place = k + part;
        }
    }
    return best;
}

bool shape_curve_has_corner(const shape_curves *c, int curve, int k)
{
    const shape_curve *s = &c->curve[curve];
    const carrier *after = &c->piece[s->first + k % s->n];
    const carrier *before = &c->piece[s->first + (k + s->n - 1) % s->n];
    double u[2], v[2];
    carrier_slope(before, before->to, u);
    carrier_slope(after, after->from, v);
    const double way = (before->to - before->from) * (after->to - after->from) > 0 ? 1 : -1;
    return fabs(atan2(way * (u[0] * v[1] - u[1] * v[0]), way * (u[0] * v[0] + u[1] * v[1]))) >
           SHARP;
}
