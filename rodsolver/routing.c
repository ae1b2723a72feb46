// rodsolver/routing.c
#include "rodsolver/routing.h"

#include "base/chebyshev.h"

#include <math.h>

static void sample(const tendon_spec *t, double s, double *x, double *y)
{
    const double radius = field_at(&t->radius, s), angle = field_at(&t->angle, s);
    *x = field_at(&t->x, s) + radius * cos(angle);
    *y = field_at(&t->y, s) + radius * sin(angle);
}

static bool path_varies(const tendon_spec *t)
{
    return field_varies(&t->radius) || field_varies(&t->angle) || field_varies(&t->x) ||
           field_varies(&t->y);
}

void routing_make(const tendon_spec *tendon, double a, double b, routing *out)
{
    out->a = a;
    out->b = b;
    out->varies = path_varies(tendon);
    const int n = out->varies ? ROUTING_NODES : 1;
    for (int i = 0; i < n; i++) {
        const double s = (a + b) / 2 + (b - a) / 2 * chebyshev_node(n, i);
        sample(tendon, s, &out->x[i], &out->y[i]);
    }
}

tendon_place routing_at(const routing *r, double s)
{
    const int n = r->varies ? ROUTING_NODES : 1;
    double value[ROUTING_NODES], slope[ROUTING_NODES];
    chebyshev_weights(n, (2 * s - r->a - r->b) / (r->b - r->a), value, slope);
    tendon_place p = {0};
    for (int i = 0; i < n; i++) {
        const double rate = slope[i] * 2 / (r->b - r->a);
        p.x += value[i] * r->x[i];
        p.y += value[i] * r->y[i];
        p.dx += rate * r->x[i];
        p.dy += rate * r->y[i];
    }
    return p;
}

// --- kinks

// Samples of the whole path, and of a piece that is looked at more closely.
enum { WIDE = 257, CLOSE = 17 };
// In a piece this part of the path long a smooth path's fourth differences are rounding ...
static const double close_piece = 1e-4;
// ... and a jump of its curvature times its length shows from here on
static const double weakest_bend = 1e-3;
// In a piece this short a path that is only bent is straight ...
static const double closest_piece = 1e-8;
// ... and a jump of (dx, dy) shows from here on
static const double weakest_kink = 1e-5;

typedef struct piece {
    double a, step;
    int n;
    double x[WIDE], y[WIDE];
} piece;

static void sample_piece(const tendon_spec *t, double a, double b, int n, piece *out)
{
    *out = (piece){.a = a, .step = (b - a) / (n - 1), .n = n};
    for (int i = 0; i < n; i++) {
        sample(t, i == n - 1 ? b : a + i * out->step, &out->x[i], &out->y[i]);
    }
}

static double fourth_difference(const double *v)
{
    return v[-2] - 4 * v[-1] + 6 * v[0] - 4 * v[1] + v[2];
}

// Fourth differences fall with the step's fourth power where the path is smooth and with the step
// at a kink: they are largest next to it
static double roughness(const piece *p, int i)
{
    return i < 2 || i > p->n - 3 ? 0
                                 : hypot(fourth_difference(p->x + i), fourth_difference(p->y + i));
}

static int roughest(const piece *p)
{
    int which = 2;
    for (int i = 3; i < p->n - 2; i++) {
        which = roughness(p, i) > roughness(p, which) ? i : which;
    }
    return which;
}

// where the straight lines through both ends of a piece meet; false where their slopes agree
static bool lines_meet(const piece *p, double *s)
{
    const int n = p->n;
    const double jump_x = (p->x[n - 1] - p->x[n - 2] - p->x[1] + p->x[0]) / p->step;
    const double jump_y = (p->y[n - 1] - p->y[n - 2] - p->y[1] + p->y[0]) / p->step;
    if (!(hypot(jump_x, jump_y) > weakest_kink)) {
        return false;
    }
    const bool in_x = fabs(jump_x) > fabs(jump_y);
    const double *v = in_x ? p->x : p->y;
    // left line v0 + (v1 - v0) t, right line from the other end, t in steps
    const double left = v[1] - v[0], right = v[n - 1] - v[n - 2];
    const double t = (v[n - 1] - v[0] - right * (n - 1)) / (left - right);
    *s = p->a + fmin(fmax(t, 0), n - 1) * p->step;
    return true;
}

// where parabolas through both ends of a piece have the same slope: there the curvature jumps
static double parabolas_touch(const piece *p)
{
    const int n = p->n;
    const double jump_x =
        p->x[0] - 2 * p->x[1] + p->x[2] - p->x[n - 3] + 2 * p->x[n - 2] - p->x[n - 1];
    const double jump_y =
        p->y[0] - 2 * p->y[1] + p->y[2] - p->y[n - 3] + 2 * p->y[n - 2] - p->y[n - 1];
    const double *v = fabs(jump_x) > fabs(jump_y) ? p->x : p->y;
    const double left = v[0] - 2 * v[1] + v[2], right = v[n - 3] - 2 * v[n - 2] + v[n - 1];
    const double t =
        (v[n - 1] - v[n - 2] - v[1] + v[0] + left / 2 - right * (n - 1.5)) / (left - right);
    return p->a + fmin(fmax(t, 0), n - 1) * p->step;
}

// samples between a and b ever closer to where the path is roughest
static void zoom(const tendon_spec *spec, double a, double b, double width, piece *p)
{
    sample_piece(spec, a, b, CLOSE, p);
    while (p->step * (CLOSE - 1) > width) {
        const int i = roughest(p);
        // a kink lies less than a step from the largest difference
        sample_piece(spec, p->a + (i - 2) * p->step, p->a + (i + 2) * p->step, CLOSE, p);
    }
}

static bool find_kink(const tendon_spec *spec, double a, double b, double *s)
{
    piece p, q;
    zoom(spec, a, b, close_piece * spec->end, &p);
    const double bend = roughness(&p, roughest(&p)) / (p.step * p.step);
    if (!(bend * spec->end > weakest_bend)) {
        return false;
    }
    zoom(spec, p.a, p.a + p.step * (CLOSE - 1), closest_piece * spec->end, &q);
    if (!lines_meet(&q, s)) {
        *s = parabolas_touch(&p);
    }
    return true;
}

int routing_kinks(const tendon_spec *spec, double *s)
{
    int count = 0;
    if (!path_varies(spec)) {
        return 0;
    }
    piece p;
    sample_piece(spec, 0, spec->end, WIDE, &p);
    for (int i = 2; i < WIDE - 2 && count < ROUTING_MAX_KINKS; i++) {
        const double here = roughness(&p, i);
        // every local maximum: a kink may be weaker than the path's bending elsewhere
        if (here > 0 && here >= roughness(&p, i - 1) && here > roughness(&p, i + 1)) {
            const double a = p.a + (i - 2) * p.step, b = p.a + (i + 2) * p.step;
            double at = 0;
            if (find_kink(spec, a, b, &at) && (count == 0 || at - s[count - 1] > p.step)) {
                s[count++] = at;
            }
        }
    }
    return count;
}
