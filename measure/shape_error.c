// measure/shape_error.c
#include "measure/shape_error.h"

#include "base/element.h"
#include "base/memory.h"
#include "measure/line_fit.h"

#include <string.h>

enum {
    GAUSS = 8,         // points of a piece
    MOST_HALVES = 30,  // of a piece where the lines cross: 2^-30 of it is left to the rule itself
    MOST_PIECES = 128, // between two stations: what they leave is rounding
};

// change of a piece that is halved, over the piece: rounding of its sums
#define QUADRATURE 1e-14
// the tangent at the tip is that of the last tenth of the line
#define TANGENT_SHARE 0.1

typedef struct two_lines {
    const model_line *model;
    const centreline *measured;
    double from, to;
    double first; // up to here the measured line is joined to the base [m]; 0: it begins later
    vec3 base;    // difference at s = 0
    double x[GAUSS], w[GAUSS];
    int *pieces;  // that may still be halved
    double total; // of the integral at hand, about
} two_lines;

static vec3 difference(const two_lines *t, double s)
{
    return vec3_sub(model_line_at(t->model, s), centreline_at(t->measured, s));
}

// at the base both are clamped: up to the first station the difference grows from 0, (9.52)
static double over_arclength(const two_lines *t, double s)
{
    vec3 d = difference(t, s);
    if (s < t->first) {
        d = vec3_add_scaled(d, s / t->first - 1, t->base);
    }
    return vec3_norm(d) / s;
}

static double size(const two_lines *t, double s)
{
    return vec3_norm(difference(t, s));
}

static double squared(const two_lines *t, double s)
{
    const vec3 d = difference(t, s);
    return vec3_dot(d, d);
}

// --- integrals

typedef double integrand(const two_lines *t, double s);

static double gauss(const two_lines *t, integrand *f, double a, double b)
{
    double sum = 0;
    for (int i = 0; i < GAUSS; i++) {
        sum += t->w[i] * f(t, 0.5 * (a + b) + 0.5 * (b - a) * t->x[i]);
    }
    return 0.5 * (b - a) * sum;
}

static double piece(const two_lines *t, integrand *f, double a, double b, double whole, int halves)
{
    const double middle = 0.5 * (a + b);
    const double left = gauss(t, f, a, middle), right = gauss(t, f, middle, b);
    if (halves == 0 || *t->pieces == 0 ||
        fabs(left + right - whole) <=
            QUADRATURE * (left + right + t->total * (b - a) / (t->to - t->from))) {
        return left + right;
    }
    (*t->pieces)--;
    return piece(t, f, a, middle, left, halves - 1) + piece(t, f, middle, b, right, halves - 1);
}

// the next station of either line after s, `to` where there is none
static double next_edge(const two_lines *t, double s, int *i, int *k)
{
    const model_line *m = t->model;
    const centreline *c = t->measured;
    while (*i < m->count && m->s[*i] <= s) {
        (*i)++;
    }
    while (*k < c->count && c->s[*k] <= s) {
        (*k)++;
    }
    double next = t->to;
    next = *i < m->count ? fmin(next, m->s[*i]) : next;
    return *k < c->count ? fmin(next, c->s[*k]) : next;
}

static double integral(const two_lines *t, integrand *f)
{
    int pieces = 0;
    two_lines own = *t;
    own.pieces = &pieces;
    own.total = 0;
    // the first pass without a piece halved tells how much a change matters
    for (int pass = 0; pass < 2; pass++) {
        double sum = 0, a = t->from;
        int i = 0, k = 0;
        while (a < t->to) {
            const double b = next_edge(t, a, &i, &k), whole = gauss(t, f, a, b);
            pieces = MOST_PIECES;
            sum += pass == 0 ? whole : piece(&own, f, a, b, whole, MOST_HALVES);
            a = b;
        }
        own.total = sum;
    }
    return own.total;
}

// over the stations of both lines, and the Gauss points between them
static void find_largest(const two_lines *t, shape_error *e)
{
    double a = t->from;
    int i = 0, k = 0;
    e->largest = size(t, a);
    e->at = a;
    while (a < t->to) {
        const double b = next_edge(t, a, &i, &k);
        for (int g = 0; g <= GAUSS; g++) {
            const double s = g < GAUSS ? 0.5 * (a + b) + 0.5 * (b - a) * t->x[g] : b;
            const double d = size(t, s);
            if (d > e->largest) {
                e->largest = d;
                e->at = s;
            }
        }
        a = b;
    }
}

// --- uncertainties

// what the distance over s at one station weighs in the integral: the trapezoids beside it, and for
// the first one all that lies before
static double station_weight(const two_lines *t, int i)
{
    const centreline *c = t->measured;
    const double s = fmin(c->s[i], t->to);
    const double before = i > 0 ? c->s[i - 1] : t->from;
    const double after = i + 1 < c->count ? fmin(c->s[i + 1], t->to) : s;
    const double left = s == t->first ? s : 0.5 * (s - before);
    return left + 0.5 * (after - s);
}

// dE = 1/(to - from) sum w_i n_i . e_i / s_i      docs/theory.md (9.54)
static status shape_uncertainty(const two_lines *t, double *sigma)
{
    status st = OK;
    const centreline *c = t->measured;
    double *s = NULL;
    vec3 *part = NULL;
    int n = 0;
    TRY(TAKE(s, (size_t)c->count));
    TRY(TAKE(part, (size_t)c->count));
    for (int i = 0; i < c->count && c->s[i] <= t->to; i++) {
        const vec3 d = difference(t, c->s[i]);
        const double away = vec3_norm(d);
        if (c->s[i] > 0) {
            // where the lines touch any direction across will do
            const vec3 toward = away > 0 ? vec3_scale(1 / away, d) : (vec3){{1, 0, 0}};
            s[n] = c->s[i];
            part[n++] = vec3_scale(station_weight(t, i) * c->sigma[i] / c->s[i], toward);
        }
    }
    *sigma = sqrt(correlated_variance(n, s, part, c->correlation_length)) / (t->to - t->from);

done:
    free(part);
    free(s);
    return st;
}

// --- the tip

enum { MOST_PLACES = 512 }; // of the line's last tenth

// of e_i over the places, each with its weight in one component of the slope
static double slope_sigma(const centreline *c, int n, const double *s, const double *sigma)
{
    double weight[MOST_PLACES];
    vec3 part[MOST_PLACES];
    line_fit_slope_weights(n, s, s[0], weight);
    for (int i = 0; i < n; i++) {
        part[i] = (vec3){{weight[i] * sigma[i], 0, 0}};
    }
    return sqrt(correlated_variance(n, s, part, c->correlation_length));
}

// The angle between the lines' tangents at their ends: of both the parabola by least squares
// through the same places.
static void angle_at_tip(const two_lines *t, shape_error *e)
{
    const centreline *c = t->measured;
    const int last = c->count - 1;
    double s[MOST_PLACES], sigma[MOST_PLACES];
    vec3 ours[MOST_PLACES], theirs[MOST_PLACES];
    int n = 0;
    for (int i = last; i >= 0 && n < MOST_PLACES; i--) {
        if (n >= 3 && c->s[i] < c->s[last] - TANGENT_SHARE * t->to) {
            break;
        }
        s[n] = c->s[i];
        sigma[n] = c->sigma[i];
        ours[n] = model_line_at(t->model, c->s[i]);
        theirs[n++] = c->p[i];
    }
    const vec3 a = line_fit_at(n, s, ours, s[0]).slope, b = line_fit_at(n, s, theirs, s[0]).slope;
    e->tip_angle = atan2(vec3_norm(vec3_cross(a, b)), vec3_dot(a, b));
    e->tip_angle_sigma = slope_sigma(c, n, s, sigma) / vec3_norm(b);
}

static void at_the_tip(const two_lines *t, bool tip, shape_error *e)
{
    const int last = t->measured->count - 1;
    const model_line *m = t->model;
    e->tip = e->tip_sigma = e->tip_angle = e->tip_angle_sigma = NAN;
    if (tip) {
        const vec3 place = t->measured->s[last] > m->s[m->count - 1]
                               ? centreline_at(t->measured, m->s[m->count - 1])
                               : t->measured->p[last];
        e->tip = vec3_norm(vec3_sub(m->p[m->count - 1], place));
        e->tip_sigma = t->measured->sigma[last];
        angle_at_tip(t, e);
    }
}

status shape_error_find(const model_line *m, const centreline *matched, bool tip, shape_error *out)
{
    status st = OK;
    shape_error e = {.base = NAN, .longer = NAN};
    two_lines t = {.model = m, .measured = matched};
    t.from = fmax(matched->s[0], 0);
    t.to = fmin(matched->s[matched->count - 1], m->s[m->count - 1]);
    if (!(t.to > t.from)) {
        return status_fail(ERR_INPUT,
                           "nothing of the rod was measured: its arclength ends at %g mm",
                           1e3 * m->s[m->count - 1]);
    }
    if (matched->s[0] <= 0) {
        t.base = difference(&t, 0);
        t.first = fmin(matched->s[1], t.to);
        e.base = vec3_norm(t.base);
    }
    gauss_legendre(GAUSS, t.x, t.w);
    const double length = t.to - t.from;
    e.from = t.from;
    e.to = t.to;
    e.shape = integral(&t, over_arclength) / length;
    e.mean = integral(&t, size) / length;
    e.rms = sqrt(integral(&t, squared) / length);
    find_largest(&t, &e);
    at_the_tip(&t, tip, &e);
    TRY(shape_uncertainty(&t, &e.shape_sigma));
    *out = e;

done:
    return st;
}
