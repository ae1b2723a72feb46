#include "meshes/morph_knots.h"

#include "base/memory.h"

#include <math.h>

// curves meet where they come as near as this part of the section's size
static const double MEET = 1e-6;
// curves whose tangents differ by less run along each other there [rad]
static const double ALONG = 1e-4;
// places nearer than this part of a piece are one
static const double ONE_PLACE = 1e-9;

void curve_knots_free(curve_knots *k)
{
    free(k->knot);
    free(k->first);
    *k = (curve_knots){0};
}

static bool at_corner(const shape_curves *c, int curve, double place)
{
    const double k = nearbyint(place);
    return fabs(place - k) < ONE_PLACE && shape_curve_has_corner(c, curve, (int)k);
}

static double cross_of(const shape_curves *c, const int curve[2], const double place[2])
{
    double u[2], v[2];
    shape_curve_slope(c, curve[0], place[0], u);
    shape_curve_slope(c, curve[1], place[1], v);
    return (u[0] * v[1] - u[1] * v[0]) / (hypot(u[0], u[1]) * hypot(v[0], v[1]));
}

// Newton's steps to where two curves cross, from places near it
static void find_crossing(const shape_curves *c, const int curve[2], double place[2])
{
    enum { STEPS = 30 };
    for (int i = 0; i < STEPS; i++) {
        double x[2], y[2], u[2], v[2];
        shape_curve_point(c, curve[0], place[0], x);
        shape_curve_point(c, curve[1], place[1], y);
        shape_curve_slope(c, curve[0], place[0], u);
        shape_curve_slope(c, curve[1], place[1], v);
        const double dx = y[0] - x[0], dy = y[1] - x[1], det = u[1] * v[0] - u[0] * v[1];
        const double a = (dy * v[0] - dx * v[1]) / det, b = (dy * u[0] - dx * u[1]) / det;
        if (!isfinite(a) || !isfinite(b)) {
            return;
        }
        // a step longer than a piece leads somewhere else
        place[0] += fmin(fmax(a, -0.25), 0.25);
        place[1] += fmin(fmax(b, -0.25), 0.25);
    }
}

// places of a meeting now; whether there is one
static bool meeting(const shape_curves *base, const shape_curves *now, const node_mark *m,
                    double size, double place[2])
{
    double x[2], y[2];
    const int lead =
        !at_corner(base, m->curve[0], m->place[0]) && at_corner(base, m->curve[1], m->place[1]);
    place[lead] = m->place[lead];
    shape_curve_point(now, m->curve[lead], place[lead], x);
    (void)shape_curve_nearest(now, m->curve[!lead], x, &place[!lead]);
    if (!at_corner(base, m->curve[lead], m->place[lead]) &&
        fabs(cross_of(base, m->curve, m->place)) > ALONG) {
        find_crossing(now, m->curve, place);
    }
    shape_curve_point(now, m->curve[0], place[0], x);
    shape_curve_point(now, m->curve[1], place[1], y);
    return hypot(x[0] - y[0], x[1] - y[1]) <= MEET * size;
}

static int by_place(const void *a, const void *b)
{
    const curve_knot *p = a, *q = b;
    return p->curve != q->curve ? p->curve - q->curve : (p->from > q->from) - (p->from < q->from);
}

static double around(double place, int n)
{
    const double x = place - n * floor(place / n);
    return n - x < ONE_PLACE ? 0 : x;
}

static void collect_corners(const shape_curves *base, curve_knots *k)
{
    for (int c = 0; c < base->ncurve; c++) {
        for (int i = 0; i < base->curve[c].n; i++) {
            if (shape_curve_has_corner(base, c, i)) {
                k->knot[k->nknot++] = (curve_knot){.curve = c, .from = i, .to = i};
            }
        }
    }
}

static bool collect_meetings(const shape_curves *base, const shape_curves *now,
                             const node_mark *mark, int nmark, double size, curve_knots *k)
{
    for (int i = 0; i < nmark; i++) {
        double place[2];
        if (mark[i].curve[1] < 0) {
            continue;
        }
        if (!meeting(base, now, &mark[i], size, place)) {
            return false;
        }
        for (int j = 0; j < 2; j++) {
            const int curve = mark[i].curve[j], n = base->curve[curve].n;
            if (!at_corner(base, curve, mark[i].place[j])) {
                k->knot[k->nknot++] = (curve_knot){curve, around(mark[i].place[j], n), place[j]};
            }
        }
    }
    return true;
}

// one knot per place, then places that run on around the curve as they did at the base
static bool unwind(const shape_curves *base, curve_knots *k)
{
    int kept = 0;
    for (int i = 0; i < k->nknot; i++) {
        const curve_knot *p = &k->knot[i], *q = kept > 0 ? &k->knot[kept - 1] : NULL;
        if (!q || q->curve != p->curve || p->from - q->from > ONE_PLACE) {
            k->knot[kept++] = *p;
        }
    }
    k->nknot = kept;
    for (int c = 0, i = 0; c < base->ncurve; c++) {
        const int n = base->curve[c].n;
        k->first[c] = i;
        for (; i < kept && k->knot[i].curve == c; i++) {
            curve_knot *p = &k->knot[i];
            p->to = i == k->first[c] ? p->from + remainder(p->to - p->from, n)
                                     : p[-1].to + around(p->to - p[-1].to, n);
        }
        k->first[c + 1] = i;
        // once around and no more, each at its own place
        for (int j = k->first[c] + 1; j < i; j++) {
            if (!(k->knot[j].to > k->knot[j - 1].to) ||
                !(k->knot[j].to < k->knot[k->first[c]].to + n)) {
                return false;
            }
        }
    }
    return true;
}

status curve_knots_make(const shape_curves *base, const shape_curves *now, const node_mark *mark,
                        int nmark, double size, curve_knots *out, bool *same)
{
    status st = OK;
    curve_knots k = {0};
    TRY(TAKE(k.knot, (size_t)base->npiece + 2 * (size_t)nmark));
    TRY(TAKE(k.first, (size_t)base->ncurve + 1));
    collect_corners(base, &k);
    *same = collect_meetings(base, now, mark, nmark, size, &k);
    if (*same) {
        qsort(k.knot, (size_t)k.nknot, sizeof *k.knot, by_place);
        *same = unwind(base, &k);
    }
    *out = k;
    k = (curve_knots){0};

done:
    curve_knots_free(&k);
    return st;
}

double curve_knots_place(const curve_knots *k, int curve, int npiece, double from)
{
    const int first = k->first[curve], last = k->first[curve + 1] - 1;
    if (last < first) {
        return from;
    }
    // the knot before, and the one after it, around the curve
    int i = last;
    for (int j = first; j < last; j++) {
        if (k->knot[j].from <= from && from < k->knot[j + 1].from) {
            i = j;
        }
    }
    curve_knot a = k->knot[i], b = k->knot[i == last ? first : i + 1];
    if (i == last) {
        b.from += npiece;
        b.to += npiece;
        from += from < a.from ? npiece : 0;
    }
    const double t = (from - a.from) / (b.from - a.from);
    return t == 1 ? b.to : a.to + t * (b.to - a.to);
}
