// meshes/loops.c
#include "meshes/loops.h"

#include "base/memory.h"
#include "meshes/outline.h"

#include <math.h>

// a chord may turn by this: it leaves its arc by 3e-4 of the radius
static const double CHORD_TURN = 0.05;
// an edge of a flattened loop is this many gaps long, so that neighbours do not count as touching
static const double SHORTEST_CHORD = 8;

curve_loop outline_curves(const outline *o, int k)
{
    return (curve_loop){.n = o->loop_start[k + 1] - o->loop_start[k],
                        .piece = o->piece + o->loop_start[k]};
}

double curves_area(curve_loop a)
{
    double about[2], sum = 0;
    carrier_start(&a.piece[0], about);
    for (int i = 0; i < a.n; i++) {
        sum += carrier_sweep(&a.piece[i], about);
    }
    return sum / 2;
}

void curves_reverse(curve_loop a)
{
    for (int i = 0, j = a.n - 1; i <= j; i++, j--) {
        const carrier first = carrier_reversed(&a.piece[i]);
        a.piece[i] = carrier_reversed(&a.piece[j]);
        a.piece[j] = first;
    }
}

bool curves_contain(curve_loop a, double x, double y)
{
    bool inside = false;
    for (int i = 0; i < a.n; i++) {
        inside ^= carrier_crosses(&a.piece[i], x, y);
    }
    return inside;
}

double curves_reach(curve_loop a)
{
    enum { SAMPLES = 16 };
    double reach = 0;
    for (int i = 0; i < a.n; i++) {
        const carrier *c = &a.piece[i];
        for (int k = 0; k < SAMPLES; k++) {
            double x[2];
            carrier_point(c, c->from + (c->to - c->from) * k / SAMPLES, x);
            reach = fmax(reach, hypot(x[0], x[1]));
        }
    }
    return reach;
}

static int chord_count(const carrier *c, double gap)
{
    double h[CARRIER_HULL][2], length = 0;
    const int n = carrier_hull(c, c->from, c->to, h);
    for (int i = 0; i + 1 < n; i++) {
        length += hypot(h[i + 1][0] - h[i][0], h[i + 1][1] - h[i][1]);
    }
    const double by_turn = ceil(carrier_turn(c) / CHORD_TURN);
    return (int)fmax(1, fmin(by_turn, floor(length / (SHORTEST_CHORD * gap))));
}

status curves_flatten(curve_loop a, double gap, flat_loop *out)
{
    status st = OK;
    flat_loop f = {0};
    size_t count = 0;
    for (int i = 0; i < a.n; i++) {
        count += (size_t)chord_count(&a.piece[i], gap);
    }
    TRY(TAKE(f.corners.p, 2 * count));
    TRY(TAKE(f.piece, count));
    for (int i = 0; i < a.n; i++) {
        const carrier *c = &a.piece[i];
        const int n = chord_count(c, gap);
        for (int k = 0; k < n; k++) {
            f.piece[f.corners.n] = i;
            carrier_point(c, c->from + (c->to - c->from) * k / n,
                          f.corners.p + 2 * (size_t)f.corners.n++);
        }
    }
    *out = f;
    f = (flat_loop){0};

done:
    flat_loop_free(&f);
    return st;
}

void flat_loop_free(flat_loop *f)
{
    free(f->corners.p);
    free(f->piece);
    *f = (flat_loop){0};
}

static status check_alone(const outline *o, int k, const flat_loop *f, double gap)
{
    int other = 0;
    const int edge = loop_self_contact(f->corners, gap, &other);
    if (edge < 0) {
        return OK;
    }
    const double *x = f->corners.p + 2 * (size_t)edge;
    const char *what = k == 0 ? "outline" : "hole";
    return outline_fail(o,
                        "pieces %d and %d of its %s cross, fold back or all but touch near "
                        "(%.6g, %.6g) mm",
                        f->piece[edge] + 1, f->piece[other] + 1, what, 1e3 * x[0], 1e3 * x[1]);
}

static status check_hole(const outline *o, int k, const flat_loop *f, double gap)
{
    const double *inside = f[k].corners.p;
    if (loops_touch(f[0].corners, f[k].corners, gap) ||
        !loop_contains(f[0].corners, inside[0], inside[1])) {
        return outline_fail(o, "hole %d does not lie inside its outline", k);
    }
    for (int j = 1; j < k; j++) {
        const double *other = f[j].corners.p;
        if (loops_touch(f[j].corners, f[k].corners, gap) ||
            loop_contains(f[j].corners, inside[0], inside[1]) ||
            loop_contains(f[k].corners, other[0], other[1])) {
            return outline_fail(o, "holes %d and %d touch or overlap", j, k);
        }
    }
    return OK;
}

status outline_check_curves(outline *o)
{
    status st = OK;
    flat_loop *f = NULL;
    double gap = 0;
    TRY(TAKE(f, (size_t)o->nloop));
    for (int k = 0; k < o->nloop; k++) {
        const curve_loop a = outline_curves(o, k);
        const double area = curves_area(a);
        // by the outer loop: a sliver of the whole
        gap = k == 0 ? OUTLINE_SLIVER * sqrt(fabs(area)) : gap;
        TRY(curves_flatten(a, gap, &f[k]));
        TRY(check_alone(o, k, &f[k], gap));
        if (!(area > 0)) {
            curves_reverse(a);
        }
    }
    for (int k = 1; k < o->nloop; k++) {
        TRY(check_hole(o, k, f, gap));
    }

done:
    for (int k = 0; f && k < o->nloop; k++) {
        flat_loop_free(&f[k]);
    }
    free(f);
    return st;
}
