// Fits of a made model, an arc with a twist, to made shapes: values, intervals, bounds, refusals.
#include "measure/gsl_door.h"
#include "measure/shape_fit.h"
#include "tests/test.h"

#include <math.h>
#include <string.h>

// curvature x[0] [1/m] and torsion x[1] [1/m] of a helix of 120 mm that begins along z; shape k has
// k + 1 times the curvature
static const double length = 0.12;

static vec3 helix(const double *x, int shape, double s)
{
    const vec6 twist = {{0, 0, s, x[0] * (shape + 1) * s, 0, x[1] * s}};
    return se3_exp(twist).p;
}

static status helices(void *context, const double *x, vec3 *p, double *L)
{
    const int nshape = *(int *)context;
    *L = length;
    for (int k = 0; k < nshape; k++) {
        for (int i = 0; i < FIT_POINTS; i++) {
            p[k * FIT_POINTS + i] = helix(x, k, length * i / (FIT_POINTS - 1));
        }
    }
    return OK;
}

enum { POINTS = 121, SHAPES = 2 };

typedef struct noise {
    double sigma, correlation, shift, turn; // of a place, along the line, of the base
} noise;

static status made(const double *x, int shape, const noise *n, const gsl_random_door *door,
                   gsl_random *g, centreline *out)
{
    status st = OK;
    double e[3] = {0};
    TRY(centreline_make(POINTS, out));
    const vec3 t = {
        {n->shift * door->normal(g), n->shift * door->normal(g), n->shift * door->normal(g)}};
    const mat3 R = so3_exp(
        (vec3){{n->turn * door->normal(g), n->turn * door->normal(g), n->turn * door->normal(g)}});
    const double rho = n->correlation > 0 ? exp(-length / (POINTS - 1) / n->correlation) : 0;
    for (int i = 0; i < POINTS; i++) {
        out->s[i] = length * i / (POINTS - 1);
        out->sigma[i] = n->sigma;
        out->p[i] = vec3_add(mat3_mul_vec(R, helix(x, shape, out->s[i])), t);
        for (int d = 0; d < 3; d++) {
            const double fresh = n->sigma * door->normal(g);
            e[d] = i == 0 ? fresh : rho * e[d] + sqrt(1 - rho * rho) * fresh;
            out->p[i].a[d] += e[d];
        }
    }

done:
    return st;
}

typedef struct setting {
    const gsl_random_door *door;
    centreline line[SHAPES];
    fit_shape shape[SHAPES];
    fit_unknown unknown[2];
    int nshape;
    fit_problem problem;
} setting;

static void set_up(setting *w, const double *x, const noise *n, unsigned long seed)
{
    gsl_random *g = NULL;
    *w = (setting){.nshape = SHAPES};
    CHECK_OK(gsl_random_door_open(&w->door));
    CHECK_OK(w->door->make(seed, &g));
    for (int k = 0; k < SHAPES; k++) {
        CHECK_OK(made(x, k, n, w->door, g, &w->line[k]));
        w->shape[k] = (fit_shape){
            .name = k ? "second" : "first", .line = &w->line[k], .rest = true, .to_tip = true};
    }
    w->door->free(g);
    w->unknown[0] = (fit_unknown){"curvature", 8, 2, 20};
    w->unknown[1] = (fit_unknown){"torsion", 3, -10, 20};
    w->problem = (fit_problem){.nunknown = 2,
                               .nshape = SHAPES,
                               .unknown = w->unknown,
                               .shape = w->shape,
                               .lines = helices,
                               .context = &w->nshape,
                               .base = FIT_BASE_EACH,
                               .base_shift = 1e-4,
                               .base_turn = 0.005,
                               .nstart = 1,
                               .seed = 1,
                               .share = 0.95};
}

static void tear_down(setting *w)
{
    for (int k = 0; k < SHAPES; k++) {
        centreline_free(&w->line[k]);
    }
}

static void exact_shapes_give_exact_values(void)
{
    setting w;
    fit_answer a = {0};
    const double x[2] = {10, 5};
    set_up(&w, x, &(noise){0}, 1);
    w.problem.nstart = 4;
    CHECK_OK(shape_fit(&w.problem, &a));
    if (a.value) {
        CHECK_NEAR(a.value[0], 10, 1e-7); // the search's step
        CHECK_NEAR(a.value[1], 5, 1e-6);
        CHECK(a.match[0].rms[0] > 1e-3 && a.match[0].rms[1] < 1e-8);
        CHECK(a.step_error < 1e-5);
        CHECK(a.nsame == a.nstart);
    }
    fit_answer_free(&a);
    tear_down(&w);
}

// how many of the intervals hold the truth
static void covers(const char *what, const noise *n, bool told, int base)
{
    const int seeds = test_is_watched() ? 10 : 100;
    const double x[2] = {10, 5};
    int inside[2] = {0};
    double spread[2] = {0}, error[2] = {0}, alike = 0;
    for (int seed = 1; seed <= seeds; seed++) {
        setting w;
        fit_answer a = {0};
        set_up(&w, x, n, (unsigned long)seed);
        w.problem.base = base;
        for (int k = 0; k < SHAPES; k++) {
            for (int i = 0; i < POINTS && !told; i++) {
                w.line[k].sigma[i] = NAN;
            }
        }
        CHECK_OK(shape_fit(&w.problem, &a));
        for (int u = 0; u < 2 && a.value; u++) {
            inside[u] += a.low[u] <= x[u] && x[u] <= a.high[u];
            spread[u] += (a.value[u] - x[u]) * (a.value[u] - x[u]) / seeds;
            error[u] += a.error[u] * a.error[u] / seeds;
        }
        alike += a.correlation_length / seeds;
        fit_answer_free(&a);
        tear_down(&w);
    }
    printf("%-44s %3d and %3d of %d inside; told / true error %.2f %.2f; correlation %.1f mm\n",
           what, inside[0], inside[1], seeds, sqrt(error[0] / spread[0]),
           sqrt(error[1] / spread[1]), 1e3 * alike);
    for (int u = 0; u < 2; u++) {
        CHECK(inside[u] >= (seeds == 100 ? 90 : 7)); // at 95 %: fewer in 1 of 100 tries at most
        CHECK(error[u] < 3 * 3 * spread[u]);         // and not by intervals of any width
    }
}

// the frame's part of a scan's sigma counts once: in the base where that is searched, else in sigma
static void the_frame_counts_once(void)
{
    const double x[2] = {10, 5};
    double error[2][2] = {{0}}; // of the curvature, [base each][own sigma told]
    for (int each = 0; each < 2; each++) {
        for (int own = 0; own < 2; own++) {
            setting w;
            fit_answer a = {0};
            set_up(&w, x, &(noise){.sigma = 5e-6}, 1);
            w.problem.base = each ? FIT_BASE_EACH : FIT_BASE_FIXED;
            for (int i = 0; i < SHAPES * POINTS; i++) {
                w.line[i / POINTS].sigma[i % POINTS] = 1e-4;
                w.line[i / POINTS].own[i % POINTS] = own ? 5e-6 : NAN;
            }
            CHECK_OK(shape_fit(&w.problem, &a));
            error[each][own] = a.error ? a.error[0] : NAN;
            fit_answer_free(&a);
            tear_down(&w);
        }
    }
    CHECK(error[0][1] == error[0][0]);
    CHECK(error[1][1] < 0.3 * error[1][0]);
}

static void a_bound_is_told(void)
{
    setting w;
    fit_answer a = {0};
    const double x[2] = {10, 5};
    set_up(&w, x, &(noise){.sigma = 5e-5, .correlation = 3e-3}, 3);
    w.unknown[1].upper = 4;
    CHECK_OK(shape_fit(&w.problem, &a));
    if (a.value) {
        CHECK(a.bound[1] == 1 && a.value[1] == 4 && a.beyond[1] > 4.5);
        CHECK(isnan(a.error[1]) && a.high[1] == 4);
        CHECK(a.bound[0] == 0 && a.error[0] > 0);
    }
    fit_answer_free(&a);
    tear_down(&w);
}

static void refused(setting *w, status code, const char *words)
{
    fit_answer a = {0};
    const status st = shape_fit(&w->problem, &a);
    if (st != code || !strstr(status_message(), words)) {
        test_failures++;
        printf("gives %d '%s', wanted '%s'\n", (int)st, status_message(), words);
    }
    status_clear();
    fit_answer_free(&a);
}

static status twice_the_same(void *context, const double *x, vec3 *p, double *L)
{
    const double sum[2] = {x[0] + 2 * x[1], 5};
    return helices(context, sum, p, L);
}

static status never_the_second(void *context, const double *x, vec3 *p, double *L)
{
    const double first[2] = {x[0], 5};
    return helices(context, first, p, L);
}

static void refuses_what_cannot_be_told(void)
{
    setting w;
    const double x[2] = {10, 5};
    set_up(&w, x, &(noise){.sigma = 5e-5}, 3);
    w.problem.lines = twice_the_same;
    refused(&w, ERR_NUMERIC, "'curvature' and 'torsion' cannot be told apart");
    w.problem.lines = never_the_second;
    refused(&w, ERR_NUMERIC, "'torsion' moves none");
    w.problem.lines = helices;
    w.line[0].count = 3;
    refused(&w, ERR_INPUT, "'first' has 3 points");
    tear_down(&w);
}

// a valley that winds: every step along it is small
static status winding(void *context, const double *x, vec3 *p, double *L)
{
    const double moved[2] = {10 + 0.02 * x[0], 5 + 5 * (x[1] - sin(30 * x[0]))};
    return helices(context, moved, p, L);
}

typedef struct counted {
    int nshape, ncall; // the first is what helices() takes
    int last_start;
    double least;
} counted;

static status count_winding(void *context, const double *x, vec3 *p, double *L)
{
    ((counted *)context)->ncall++;
    return winding(context, x, p, L);
}

static void hear(void *context, int start, double chi2)
{
    counted *c = context;
    c->last_start = start;
    c->least = fmin(c->least, chi2);
}

static void what_gets_nowhere_ends_soon_and_says_where(void)
{
    setting w;
    const double x[2] = {10, 5};
    counted c = {.nshape = SHAPES, .least = INFINITY};
    set_up(&w, x, &(noise){.sigma = 5e-5}, 3);
    w.problem.lines = count_winding;
    w.problem.context = &c;
    w.problem.progress = hear;
    w.problem.nstart = 4;
    w.unknown[0] = (fit_unknown){"curvature", -8, -30, 30};
    w.unknown[1] = (fit_unknown){"torsion", 0, -10, 10};
    refused(&w, ERR_NUMERIC, "best so far: chi^2 ");
    refused(&w, ERR_NUMERIC, "curvature = ");
    refused(&w, ERR_NUMERIC, "tell least of 'curvature'");
    CHECK(c.last_start == 1 && isfinite(c.least)); // half of the starts were enough
    CHECK(c.ncall < 3 * 2 * 24 * 12); // three fits, two searches, their steps, solves of a step
    tear_down(&w);
}

// no shape where the torsion is negative
static status half_a_model(void *context, const double *x, vec3 *p, double *L)
{
    return x[1] < 0 ? status_fail(ERR_NUMERIC, "none") : helices(context, x, p, L);
}

static void one_search_that_ends_is_enough(void)
{
    setting w;
    fit_answer a = {0};
    const double x[2] = {10, 5};
    set_up(&w, x, &(noise){.sigma = 5e-5}, 3);
    w.problem.lines = half_a_model;
    w.problem.nstart = 8;
    CHECK_OK(shape_fit(&w.problem, &a));
    CHECK(a.nstart == 8 && a.nended < 8 && a.nended >= 1 && a.nsame <= a.nended);
    if (a.value) {
        CHECK(a.low[0] < 10.1 && a.high[0] > 9.9);
    }
    fit_answer_free(&a);
    tear_down(&w);
}

int main(void)
{
    what_gets_nowhere_ends_soon_and_says_where();
    one_search_that_ends_is_enough();
    exact_shapes_give_exact_values();
    a_bound_is_told();
    the_frame_counts_once();
    refuses_what_cannot_be_told();
    const noise white = {.sigma = 5e-5}, smooth = {.sigma = 5e-5, .correlation = 4e-3},
                off = {.sigma = 5e-5, .correlation = 4e-3, .shift = 1e-4, .turn = 0.005};
    covers("white, sigma told", &white, true, FIT_BASE_FIXED);
    covers("white, sigma not told", &white, false, FIT_BASE_FIXED);
    covers("4 mm together, sigma told", &smooth, true, FIT_BASE_FIXED);
    covers("4 mm together, sigma not told", &smooth, false, FIT_BASE_FIXED);
    covers("4 mm together, bases off, sigma told", &off, true, FIT_BASE_EACH);
    covers("4 mm together, bases off, sigma not told", &off, false, FIT_BASE_EACH);
    return test_failures != 0;
}
