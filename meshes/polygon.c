// meshes/polygon.c
#include "meshes/polygon.h"

#include <math.h>

loop outline_loop(const outline *o, int k)
{
    return (loop){.n = o->loop_start[k + 1] - o->loop_start[k],
                  .p = o->point + 2 * (size_t)o->loop_start[k]};
}

static const double *corner(loop a, int i)
{
    return a.p + 2 * (size_t)(i % a.n);
}

double loop_area(loop a)
{
    double twice = 0;
    for (int i = 0; i < a.n; i++) {
        const double *p = corner(a, i), *q = corner(a, i + 1);
        // from the first corner, so that a loop far from the origin keeps its digits
        twice += (p[0] - a.p[0]) * (q[1] - a.p[1]) - (q[0] - a.p[0]) * (p[1] - a.p[1]);
    }
    return twice / 2;
}

void loop_reverse(loop a)
{
    for (int i = 0, j = a.n - 1; i < j; i++, j--) {
        for (int d = 0; d < 2; d++) {
            const double t = a.p[2 * i + d];
            a.p[2 * i + d] = a.p[2 * j + d];
            a.p[2 * j + d] = t;
        }
    }
}

bool loop_contains(loop a, double x, double y)
{
    bool inside = false;
    for (int i = 0; i < a.n; i++) {
        const double *p = corner(a, i), *q = corner(a, i + 1);
        if ((p[1] > y) != (q[1] > y)) {
            const double cut = p[0] + (y - p[1]) / (q[1] - p[1]) * (q[0] - p[0]);
            inside ^= x < cut;
        }
    }
    return inside;
}

static double point_distance(const double *x, const double *p, const double *q)
{
    const double dx = q[0] - p[0], dy = q[1] - p[1], square = dx * dx + dy * dy;
    double t = square > 0 ? ((x[0] - p[0]) * dx + (x[1] - p[1]) * dy) / square : 0;
    t = fmin(fmax(t, 0), 1);
    return hypot(x[0] - p[0] - t * dx, x[1] - p[1] - t * dy);
}

static double side(const double *p, const double *q, const double *x)
{
    return (q[0] - p[0]) * (x[1] - p[1]) - (q[1] - p[1]) * (x[0] - p[0]);
}

static bool apart(double a, double b, double c, double d, double gap)
{
    return fmax(a, b) + gap < fmin(c, d) || fmax(c, d) + gap < fmin(a, b);
}

static bool edges_touch(const double *p, const double *q, const double *r, const double *s,
                        double gap)
{
    if (apart(p[0], q[0], r[0], s[0], gap) || apart(p[1], q[1], r[1], s[1], gap)) {
        return false;
    }
    if ((side(p, q, r) > 0) != (side(p, q, s) > 0) && (side(r, s, p) > 0) != (side(r, s, q) > 0)) {
        return true;
    }
    return point_distance(p, r, s) < gap || point_distance(q, r, s) < gap ||
           point_distance(r, p, q) < gap || point_distance(s, p, q) < gap;
}

int loop_self_contact(loop a, double gap, int *other)
{
    for (int i = 0; i < a.n; i++) {
        const double *p = corner(a, i), *q = corner(a, i + 1), *next = corner(a, i + 2);
        *other = (i + 1) % a.n;
        const bool is_short = hypot(q[0] - p[0], q[1] - p[1]) < gap;
        if (is_short || point_distance(next, p, q) < gap || point_distance(p, q, next) < gap) {
            return i;
        }
        for (int j = i + 2; j < a.n; j++) {
            *other = j;
            if ((j + 1) % a.n != i && edges_touch(p, q, corner(a, j), corner(a, j + 1), gap)) {
                return i;
            }
        }
    }
    return -1;
}

// the corners' smallest and largest x and y
static void box_of(loop a, double low[2], double high[2])
{
    for (int d = 0; d < 2; d++) {
        low[d] = INFINITY;
        high[d] = -INFINITY;
        for (int i = 0; i < a.n; i++) {
            low[d] = a.p[2 * i + d] < low[d] ? a.p[2 * i + d] : low[d];
            high[d] = a.p[2 * i + d] > high[d] ? a.p[2 * i + d] : high[d];
        }
    }
}

bool loops_touch(loop a, loop b, double gap)
{
    double low[2], high[2];
    box_of(b, low, high);
    for (int i = 0; i < a.n; i++) {
        const double *p = corner(a, i), *q = corner(a, i + 1);
        if (apart(p[0], q[0], low[0], high[0], gap) || apart(p[1], q[1], low[1], high[1], gap)) {
            continue;
        }
        for (int j = 0; j < b.n; j++) {
            if (edges_touch(p, q, corner(b, j), corner(b, j + 1), gap)) {
                return true;
            }
        }
    }
    return false;
}
