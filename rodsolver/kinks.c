// rodsolver/kinks.c
#include "rodsolver/kinks.h"

#include "rodsolver/routing.h"

#include <math.h>

// Samples of the whole curve, and of a piece that is looked at more closely.
enum { WIDE = 257, CLOSE = 17 };
// In a piece this part of the curve long a smooth curve's fourth differences are rounding ...
static const double close_piece = 1e-4;
// ... and a jump of its second derivative times its length shows from here on
static const double weakest_bend = 1e-3;
// In a piece this short a curve that is only bent is straight ...
static const double closest_piece = 1e-8;
// ... a jump of its slope shows from here on ...
static const double weakest_kink = 1e-5;
// ... and one of its value from this part of the length on
static const double weakest_jump = 1e-6;
// halvings of an interval until its ends are neighbours among the numbers
enum { HALVINGS = 60 };

// what varies, with slopes of order 1 where it is a field
typedef struct curve {
    const tendon_spec *path; // or
    const field *f;
    double scale;
    double from, to;
} curve;

static void curve_at(const curve *c, double s, double v[2])
{
    if (c->path) {
        routing_place(c->path, s, &v[0], &v[1]);
    } else {
        v[0] = c->scale * field_at(c->f, s);
        v[1] = 0;
    }
}

typedef struct piece {
    double a, step;
    int n;
    double x[WIDE], y[WIDE];
} piece;

static void sample_piece(const curve *c, double a, double b, int n, piece *out)
{
    *out = (piece){.a = a, .step = (b - a) / (n - 1), .n = n};
    for (int i = 0; i < n; i++) {
        double v[2];
        curve_at(c, i == n - 1 ? b : a + i * out->step, v);
        out->x[i] = v[0];
        out->y[i] = v[1];
    }
}

static double fourth_difference(const double *v)
{
    return v[-2] - 4 * v[-1] + 6 * v[0] - 4 * v[1] + v[2];
}

// Fourth differences fall with the step's fourth power where the curve is smooth and with the step
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

// where parabolas through both ends of a piece have the same slope: there the second derivative
// jumps
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

// samples between a and b ever closer to where the curve is roughest
static void zoom(const curve *c, double a, double b, double width, piece *p)
{
    sample_piece(c, a, b, CLOSE, p);
    while (p->step * (CLOSE - 1) > width) {
        const int i = roughest(p);
        // a kink lies less than a step from the largest difference
        sample_piece(c, p->a + (i - 2) * p->step, p->a + (i + 2) * p->step, CLOSE, p);
    }
}

// a step of the value inside a piece; tendons do not jump, a load may
static bool value_jumps(const curve *c, const piece *p, double *s)
{
    int at = 0;
    for (int i = 1; i + 1 < p->n; i++) {
        at = fabs(p->x[i + 1] - p->x[i]) > fabs(p->x[at + 1] - p->x[at]) ? i : at;
    }
    double a = p->a + at * p->step, b = a + p->step, low = p->x[at], high = p->x[at + 1];
    if (c->path || !(fabs(high - low) > weakest_jump * (c->to - c->from))) {
        return false;
    }
    for (int i = 0; i < HALVINGS; i++) {
        double v[2];
        const double middle = (a + b) / 2;
        curve_at(c, middle, v);
        if (fabs(v[0] - low) < fabs(v[0] - high)) {
            a = middle;
            low = v[0];
        } else {
            b = middle;
            high = v[0];
        }
    }
    *s = b;
    return true;
}

static bool find_kink(const curve *c, double a, double b, double *s)
{
    piece p, q;
    const double length = c->to - c->from;
    zoom(c, a, b, close_piece * length, &p);
    const double bend = roughness(&p, roughest(&p)) / (p.step * p.step);
    if (!(bend * length > weakest_bend)) {
        return false;
    }
    zoom(c, p.a, p.a + p.step * (CLOSE - 1), closest_piece * length, &q);
    if (!value_jumps(c, &q, s) && !lines_meet(&q, s)) {
        *s = parabolas_touch(&p);
    }
    return true;
}

static int find_kinks(const curve *c, double *s)
{
    int count = 0;
    piece p;
    sample_piece(c, c->from, c->to, WIDE, &p);
    for (int i = 2; i < WIDE - 2 && count < MOST_KINKS; i++) {
        const double here = roughness(&p, i);
        // every local maximum: a kink may be weaker than the curve's bending elsewhere
        if (here > 0 && here >= roughness(&p, i - 1) && here > roughness(&p, i + 1)) {
            const double a = p.a + (i - 2) * p.step, b = p.a + (i + 2) * p.step;
            double at = 0;
            if (find_kink(c, a, b, &at) && (count == 0 || at - s[count - 1] > p.step)) {
                s[count++] = at;
            }
        }
    }
    return count;
}

int kinks_of_tendon(const tendon_spec *spec, double *s)
{
    const curve c = {.path = spec, .from = 0, .to = spec->end};
    return routing_varies(spec) ? find_kinks(&c, s) : 0;
}

int kinks_of_field(const field *f, double from, double to, double *s)
{
    curve c = {.f = f, .scale = 1, .from = from, .to = to};
    double most = 0;
    if (!field_varies(f) || !(to > from)) {
        return 0;
    }
    for (int i = 0; i < WIDE; i++) {
        most = fmax(most, fabs(field_at(f, from + (to - from) * i / (WIDE - 1))));
    }
    c.scale = (to - from) / most;
    return most > 0 ? find_kinks(&c, s) : 0;
}
