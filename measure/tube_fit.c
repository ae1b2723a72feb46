// measure/tube_fit.c
// The whole line at once: robust distances of all points from the tube, and a penalty on what is
// rough. Unknowns are the coefficients, coefficient after coefficient, then the radius and its
// taper.
#include "measure/tube_inside.h"
#include "measure/tube_normal.h"

#include "base/memory.h"

#include <float.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_ROUNDS = 40, SMOOTHING_ROUNDS = 2, LEAST_ROUNDS = 6, MOST_POINTS = 200000 };

static const double near_trace = 2.2;      // radii: points that are looked at
static const double beyond_trace = 1.5;    // radii that the line goes on beyond its first and last
                                           // cylinder
static const double start_smoothing = 0.5; // radii
static const double fade = 5;              // deviations at which a point no longer counts
// radii: while the smoothing is not yet chosen, its bias must not cost points
static const double least_reach = 1e-4, first_reach = 0.02;
static const double settled = 5e-3;            // of the noise
static const double normal_deviation = 1.4826; // of a median without sign

void tube_fit_free(tube_fit *f)
{
    free(f->p);
    free(f->u);
    free(f->res);
    free(f->weight);
    free(f->work);
    free(f->covariance);
    tube_curve_free(&f->curve);
    *f = (tube_fit){0};
}

// how far the line goes on before the first cylinder
static double before_first(const tube_trace *trace, const tube_options *o)
{
    const double r = trace->at[0].radius;
    const double height =
        o->base_is_plane ? vec3_dot(vec3_sub(trace->at[0].c, o->base), o->direction) : 0;
    return fmax(beyond_trace * r, height + 0.5 * r);
}

static status first_curve(const tube_trace *trace, const tube_options *o, double *u, tube_fit *f)
{
    status st = OK;
    vec3 *p = NULL;
    const double r = f->radius;
    TRY(TAKE(p, (size_t)trace->count));
    for (int i = 0; i < trace->count; i++) {
        p[i] = trace->at[i].c;
        u[i] = i ? u[i - 1] + vec3_norm(vec3_sub(p[i], p[i - 1])) : before_first(trace, o);
    }
    const double length = u[trace->count - 1] + beyond_trace * r;
    const int npiece = (int)fmax(1, fmin(TUBE_MOST_PIECES, ceil(length / r)));
    TRY(tube_curve_make(f->curve.door, npiece, length, &f->curve));
    TRY(tube_curve_through(&f->curve, trace->count, u, p, start_smoothing * r));

done:
    free(p);
    return st;
}

typedef struct owner {
    float distance; // 0: of none
    int station;
} owner;

// every point near the trace goes to its nearest cylinder
static size_t find_owners(const tube_grid *grid, const tube_trace *trace, double reach,
                          uint32_t *near, owner *of)
{
    size_t count = 0;
    for (int i = 0; i < trace->count; i++) {
        const size_t n = tube_grid_near(grid, trace->at[i].c, reach, near, grid->count);
        for (size_t k = 0; k < n; k++) {
            const double *q = grid->p[near[k]];
            const vec3 v = vec3_sub((vec3){{q[0], q[1], q[2]}}, trace->at[i].c);
            const float d = (float)vec3_norm(v) + FLT_MIN;
            count += of[near[k]].distance == 0;
            if (of[near[k]].distance == 0 || d < of[near[k]].distance) {
                of[near[k]] = (owner){d, i};
            }
        }
    }
    return count;
}

// Where there are very many, every so manyth: cell after cell, so evenly everywhere. Thinning dense
// places alone would make much of the few points at the surface's fringe.
static status take_points(const tube_grid *grid, const tube_trace *trace, const double *u,
                          tube_fit *f)
{
    status st = OK;
    owner *of = NULL;
    uint32_t *near = NULL;
    size_t seen = 0;
    TRY(TAKE(of, grid->count));
    TRY(TAKE(near, grid->count));
    const size_t count = find_owners(grid, trace, near_trace * f->radius, near, of);
    const size_t every = 1 + count / MOST_POINTS, room = count / every + 1;
    TRY(TAKE(f->p, room));
    TRY(TAKE(f->u, room));
    TRY(TAKE(f->res, room));
    TRY(TAKE(f->weight, room));
    TRY(TAKE(f->work, room));
    for (size_t k = 0; k < grid->count; k++) {
        if (of[k].distance > 0 && seen++ % every == 0) {
            const tube_station *s = &trace->at[of[k].station];
            const vec3 q = {{grid->p[k][0], grid->p[k][1], grid->p[k][2]}};
            memcpy(f->p[f->count], q.a, sizeof q.a);
            f->u[f->count++] = u[of[k].station] + vec3_dot(vec3_sub(q, s->c), s->t);
        }
    }

done:
    free(of);
    free(near);
    return st;
}

status tube_fit_make(const tube_grid *grid, const tube_trace *trace, const tube_options *options,
                     const gsl_spline_door *door, tube_fit *out)
{
    status st = OK;
    double *u = NULL;
    const double first = trace->at[0].radius, last = trace->at[trace->count - 1].radius;
    tube_fit f = {.curve = {.door = door},
                  .radius = (first + last) / 2,
                  .taper = last - first,
                  .free_radius = first != options->radius || last != first, // or not given
                  .radius_sigma = 0,
                  .free_taper = true,
                  .given_noise = options->noise,
                  .given_smoothing = options->smoothing};
    TRY(TAKE(u, (size_t)trace->count));
    TRY(first_curve(trace, options, u, &f));
    TRY(take_points(grid, trace, u, &f));
    *out = f;
    f = (tube_fit){0};

done:
    free(u);
    tube_fit_free(&f);
    return st;
}

static int by_size(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

double tube_fit_radius(const tube_fit *f, double u)
{
    return f->radius + f->taper * (u / f->curve.length - 0.5);
}

void tube_fit_residuals(tube_fit *f, double reach)
{
    size_t n = 0;
    for (size_t i = 0; i < f->count; i++) {
        const vec3 q = {{f->p[i][0], f->p[i][1], f->p[i][2]}};
        const double u = tube_curve_foot(&f->curve, q, f->u[i], 2);
        const bool on = u >= 0 && u <= f->curve.length;
        f->u[i] = u;
        f->res[i] = on ? vec3_norm(vec3_sub(q, tube_curve_at(&f->curve, u, NULL, NULL))) -
                             tube_fit_radius(f, u)
                       : (double)INFINITY;
        if (fabs(f->res[i]) < reach) {
            f->work[n++] = fabs(f->res[i]);
        }
    }
    // a sample's median is near enough
    const size_t every = 1 + n / 20000;
    size_t few = 0;
    for (size_t i = 0; i < n; i += every) {
        f->work[few++] = f->work[i];
    }
    qsort(f->work, few, sizeof *f->work, by_size);
    f->noise = few ? normal_deviation * f->work[few / 2] : 0;
    if (isfinite(f->given_noise)) {
        f->noise = fmax(f->noise, f->given_noise);
    }
}

static void weigh(tube_fit *f, double reach)
{
    for (size_t i = 0; i < f->count; i++) {
        const double z = f->res[i] / reach;
        f->weight[i] = fabs(z) < 1 ? (1 - z * z) * (1 - z * z) : 0;
    }
}

static void move(tube_fit *f, const double *step, double *moved)
{
    double sum = 0;
    for (int k = 0; k < 3 * f->curve.ncoef; k++) {
        f->curve.coef[k / 3][k % 3] += step[k];
        sum += step[k] * step[k];
    }
    f->radius += step[3 * f->curve.ncoef];
    f->taper += step[3 * f->curve.ncoef + 1];
    *moved = sqrt(sum / f->curve.ncoef);
    tube_curve_set(&f->curve);
}

status tube_fit_solve(tube_fit *f, double reach, bool choose, bool last)
{
    status st = OK;
    tube_normal n = {0};
    double moved = INFINITY;
    const double r = f->radius;
    f->smoothing = isfinite(f->given_smoothing) ? f->given_smoothing
                   : f->smoothing > 0           ? f->smoothing
                                                : start_smoothing * r;
    TRY(tube_normal_make(&f->curve, &n));
    for (int i = 0; i < MOST_ROUNDS && (i < LEAST_ROUNDS || moved > settled * f->noise); i++) {
        tube_fit_residuals(f, reach);
        reach = fmax(fmin(fade * f->noise, reach), (last ? least_reach : first_reach) * r);
        weigh(f, reach);
        tube_normal_fill(f, &n);
        if (choose && !isfinite(f->given_smoothing) && i >= 2 && i < 2 + SMOOTHING_ROUNDS) {
            TRY(tube_normal_choose(f, &n));
        }
        TRY(tube_normal_step(f, &n, false));
        move(f, n.step, &moved);
        if (!(f->radius > 0.5 * r && f->radius < 2 * r)) {
            TRY(status_fail(ERR_FILE, "the points do not decide the tube's radius"));
        }
    }
    if (!(moved < 0.1 * f->noise + 1e-6 * r)) {
        TRY(status_fail(ERR_NUMERIC, "the centreline does not settle: it still moves by %.3g mm",
                        moved * 1e3));
    }
    TRY(tube_normal_covariance(f, &n, reach));

done:
    tube_normal_free(&n);
    return st;
}

// 3x3 block of the covariance of the places at u and v, across the line's directions there: its
// trace                                                                                   (9.9)
static double across(const tube_fit *f, double u, double v)
{
    const tube_curve *c = &f->curve;
    const size_t n = 3 * (size_t)c->ncoef + 2;
    double x = 0, y = 0, b[TUBE_ORDER], d[TUBE_ORDER], block[3][3] = {{0}};
    const int i = tube_curve_piece(c, u, &x), j = tube_curve_piece(c, v, &y);
    tube_curve_basis(c, i, x, 0, b);
    tube_curve_basis(c, j, y, 0, d);
    for (int k = 0; k < TUBE_ORDER * TUBE_ORDER; k++) {
        const int row = i + k / TUBE_ORDER, column = j + k % TUBE_ORDER;
        for (int e = 0; e < 9; e++) {
            block[e / 3][e % 3] +=
                b[k / TUBE_ORDER] * d[k % TUBE_ORDER] *
                f->covariance[(size_t)(3 * row + e / 3) * n + (size_t)(3 * column + e % 3)];
        }
    }
    vec3 s, t;
    (void)tube_curve_at(c, u, &s, NULL);
    (void)tube_curve_at(c, v, &t, NULL);
    s = vec3_scale(1 / vec3_norm(s), s);
    t = vec3_scale(1 / vec3_norm(t), t);
    const mat3 B = {{{block[0][0], block[0][1], block[0][2]},
                     {block[1][0], block[1][1], block[1][2]},
                     {block[2][0], block[2][1], block[2][2]}}};
    const vec3 Bt = mat3_mul_vec(B, t), Bs = mat3_tmul_vec(B, s);
    return B.a[0][0] + B.a[1][1] + B.a[2][2] - vec3_dot(t, Bt) - vec3_dot(s, Bs) +
           vec3_dot(s, t) * vec3_dot(s, Bt);
}

double tube_fit_sigma(const tube_fit *f, double u)
{
    return sqrt(fmax(0, across(f, u, u) / 2));
}

double tube_fit_correlation(const tube_fit *f, double u, double v)
{
    return across(f, u, v) / sqrt(fmax(1e-300, across(f, u, u) * across(f, v, v)));
}
