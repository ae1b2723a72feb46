// measure/fit_spread.c
#include "measure/fit_spread.h"

#include "base/memory.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

// An unknown that moves all shapes by less than this over its whole range, in standard deviations
// of all places together, moves none of them.
static const double moves_nothing = 1e-3;
// What is left of its effect when the base may move: less, and the base does the same.
static const double as_the_base = 1e-6;
// The smallest eigenvalue of the unknowns' normal equations, scaled to a diagonal of ones; below,
// differences of shapes cannot tell them apart: derivatives by differences are good to some 1e-5.
static const double told_apart = 1e-7;
// An unknown takes part in a combination by more than this of its vector.
static const double takes_part = 0.2;

// --- unknowns that cannot be told apart

static const char *name_of(const fit *f, int k)
{
    return f->problem->unknown[f->free[k]].name;
}

static void names_of(const fit *f, const double *vector, char *words, size_t room)
{
    size_t used = 0;
    words[0] = '\0';
    for (int k = 0; k < f->nfree; k++) {
        if (fabs(vector[k * f->nfree]) > takes_part && used < room) {
            used += (size_t)snprintf(words + used, room - used, "%s'%.60s'", used ? " and " : "",
                                     name_of(f, k));
        }
    }
}

static status check_each(const fit *f, const double *S, const double *held)
{
    for (int k = 0; k < f->nfree; k++) {
        if (!(sqrt(held[k]) > moves_nothing)) {
            return status_fail(ERR_NUMERIC,
                               "fit: '%.60s' moves none of the measured shapes: it cannot be "
                               "fitted to them",
                               name_of(f, k));
        }
        if (!(S[k * f->nfree + k] > as_the_base * held[k])) {
            return status_fail(ERR_NUMERIC,
                               "fit: what '%.60s' does to the shapes a motion of their base does "
                               "too: it cannot be told from that",
                               name_of(f, k));
        }
    }
    return OK;
}

// S scaled to a diagonal of ones: eigenvalues, ascending, and vectors
static status decompose(const fit *f, const double *S, double *value, double *vector)
{
    const int n = f->nfree;
    double scaled[FIT_MOST_UNKNOWNS * FIT_MOST_UNKNOWNS];
    for (int i = 0; i < n; i++) {
        for (int j = 0; j < n; j++) {
            scaled[i * n + j] = S[i * n + j] / sqrt(S[i * n + i] * S[j * n + j]);
        }
    }
    return f->door->eigen(n, scaled, value, vector);
}

static status check_together(const fit *f, const double *value, const double *vector)
{
    char words[400];
    if (value[0] > told_apart) {
        return OK;
    }
    names_of(f, vector, words, sizeof words);
    return status_fail(ERR_NUMERIC,
                       "fit: %s cannot be told apart by these shapes: only a combination of them "
                       "moves anything (fit fewer, or measure what one of them does alone)",
                       words);
}

status fit_told_apart(fit *f, const double *z)
{
    status st = OK;
    double S[FIT_MOST_UNKNOWNS * FIT_MOST_UNKNOWNS], held[FIT_MOST_UNKNOWNS];
    double value[FIT_MOST_UNKNOWNS], vector[FIT_MOST_UNKNOWNS * FIT_MOST_UNKNOWNS];
    if (f->nfree == 0) {
        return OK;
    }
    TRY(fit_normal(f, z, S, held));
    TRY(check_each(f, S, held));
    TRY(decompose(f, S, value, vector));
    TRY(check_together(f, value, vector));

done:
    return st;
}

void fit_weakest(fit *f, const double *z, char *words, size_t room)
{
    double S[FIT_MOST_UNKNOWNS * FIT_MOST_UNKNOWNS], held[FIT_MOST_UNKNOWNS];
    double value[FIT_MOST_UNKNOWNS], vector[FIT_MOST_UNKNOWNS * FIT_MOST_UNKNOWNS];
    words[0] = '\0';
    if (f->nfree == 0 || fit_normal(f, z, S, held) != OK || decompose(f, S, value, vector) != OK) {
        status_clear();
        return;
    }
    names_of(f, vector, words, room);
}

// (J^T J)^-1 of the free unknowns in their units, the base's motions taken into account [n][n]
static status covariance(fit *f, const double *z, double *out)
{
    status st = OK;
    const int n = f->nfree;
    double S[FIT_MOST_UNKNOWNS * FIT_MOST_UNKNOWNS], held[FIT_MOST_UNKNOWNS];
    double value[FIT_MOST_UNKNOWNS], vector[FIT_MOST_UNKNOWNS * FIT_MOST_UNKNOWNS];
    TRY(fit_normal(f, z, S, held));
    TRY(check_each(f, S, held));
    TRY(decompose(f, S, value, vector));
    TRY(check_together(f, value, vector));
    for (int i = 0; i < n; i++) {
        for (int j = 0; j < n; j++) {
            double sum = 0;
            for (int k = 0; k < n; k++) {
                sum += vector[i * n + k] * vector[j * n + k] / value[k];
            }
            out[i * n + j] = sum * f->scale[f->free[i]] * f->scale[f->free[j]] /
                             sqrt(S[i * n + i] * S[j * n + j]);
        }
    }

done:
    return st;
}

status fit_spread_held(fit *f, const double *z, int k, fit_spread *spread)
{
    status st = OK;
    double c[FIT_MOST_UNKNOWNS * FIT_MOST_UNKNOWNS];
    TRY(covariance(f, z, c));
    spread->deviation[f->free[k]] = sqrt(c[k * f->nfree + k]);

done:
    return st;
}

// --- intervals

static double cut(double x, const fit_unknown *u)
{
    return fmin(fmax(x, u->lower), u->upper);
}

static void set_interval(const fit *f, int u, double middle, double error, fit_answer *out)
{
    const fit_unknown *own = &f->problem->unknown[u];
    out->low[u] = cut(middle - out->quantile * error, own);
    out->high[u] = cut(middle + out->quantile * error, own);
}

static void set_free_ones(const fit *f, const double *c, fit_answer *out)
{
    const int n = f->nfree, all = out->nunknown;
    for (int i = 0; i < n; i++) {
        const int u = f->free[i];
        out->error[u] = out->scale * sqrt(c[i * n + i]);
        set_interval(f, u, out->value[u], out->error[u], out);
        for (int j = 0; j < n; j++) {
            out->correlation[u * all + f->free[j]] =
                i == j ? 1 : c[i * n + j] / sqrt(c[i * n + i] * c[j * n + j]);
        }
    }
}

static void set_held_ones(const fit *f, const fit_spread *spread, fit_answer *out)
{
    for (int u = 0; u < out->nunknown; u++) {
        out->bound[u] = spread->bound[u];
        out->beyond[u] = spread->beyond[u];
        if (spread->bound[u] != 0) {
            set_interval(f, u, spread->beyond[u], out->scale * spread->deviation[u], out);
        }
    }
}

static status set_condition(const fit *f, const double *c, fit_answer *out)
{
    status st = OK;
    const int n = f->nfree;
    double scaled[FIT_MOST_UNKNOWNS * FIT_MOST_UNKNOWNS], value[FIT_MOST_UNKNOWNS],
        vector[FIT_MOST_UNKNOWNS * FIT_MOST_UNKNOWNS];
    out->condition = 1;
    for (int i = 0; i < n; i++) {
        for (int j = 0; j < n; j++) {
            scaled[i * n + j] = c[i * n + j] / sqrt(c[i * n + i] * c[j * n + j]);
        }
    }
    if (n > 0) {
        TRY(f->door->eigen(n, scaled, value, vector));
        out->condition = value[n - 1] / value[0];
    }

done:
    return st;
}

static void set_errors(const fit *f, double cost, fit_answer *out)
{
    bool told = true, any_told = false;
    for (int i = 0; i < f->nall; i++) {
        told = told && f->all[i].sigma > 0;
        any_told = any_told || f->all[i].sigma > 0;
    }
    out->chi2 = cost;
    out->freedom = 2 * f->nuse - f->nfree;
    out->sigma_known = told;
    out->sigma = told ? NAN : f->sigma;
    out->nplace = f->nuse;
    out->correlation_length = f->length;
    out->correlation_from = f->length_from;
    // errors larger than told, or than what was taken for them, are in the residuals; smaller ones
    // may be luck where they were told
    const double ratio = sqrt(cost / out->freedom);
    out->scale = any_told ? fmax(ratio, 1) : ratio;
}

// the derivatives by steps twice as large, against those used
static status find_step_error(fit *f, fit_answer *out)
{
    status st = OK;
    vec3 *once = NULL, *twice = NULL;
    TRY(TAKE(once, (size_t)f->nall));
    TRY(TAKE(twice, (size_t)f->nall));
    out->step_error = 0;
    TRY(fit_solve(f, f->x));
    for (int k = 0; k < f->nfree; k++) {
        double off = 0, all = 0;
        TRY(fit_difference(f, f->x, f->free[k], 1e-3, once));
        TRY(fit_difference(f, f->x, f->free[k], 2e-3, twice));
        for (int i = 0; i < f->nall; i++) {
            const vec3 d = vec3_sub(once[i], twice[i]);
            off += vec3_dot(d, d);
            all += vec3_dot(once[i], once[i]);
        }
        // of second order: the smaller steps are off by a third of the difference
        out->step_error = fmax(out->step_error, all > 0 ? sqrt(off / all) / 3 : 0);
    }

done:
    free(once);
    free(twice);
    return st;
}

status fit_spread_find(fit *f, const double *z, double cost, const fit_spread *spread,
                       fit_answer *out)
{
    status st = OK;
    const gsl_random_door *door = NULL;
    double c[FIT_MOST_UNKNOWNS * FIT_MOST_UNKNOWNS];
    TRY(gsl_random_door_open(&door));
    for (int u = 0; u < out->nunknown; u++) {
        out->value[u] = f->x[u];
        out->error[u] = NAN;
    }
    for (int i = 0; i < out->nunknown * out->nunknown; i++) {
        out->correlation[i] = NAN;
    }
    set_errors(f, cost, out);
    out->quantile = door->student(f->problem->share, out->freedom);
    TRY(covariance(f, z, c));
    set_free_ones(f, c, out);
    set_held_ones(f, spread, out);
    TRY(set_condition(f, c, out));
    TRY(find_step_error(f, out));
    out->nsolve = f->nsolve;

done:
    return st;
}

// --- room

status fit_answer_make(int nunknown, int nshape, fit_answer *out)
{
    status st = OK;
    const size_t n = (size_t)nunknown;
    fit_answer a = {.nunknown = nunknown, .nshape = nshape};
    TRY(TAKE(a.value, n));
    TRY(TAKE(a.error, n));
    TRY(TAKE(a.low, n));
    TRY(TAKE(a.high, n));
    TRY(TAKE(a.bound, n));
    TRY(TAKE(a.beyond, n));
    TRY(TAKE(a.correlation, n * n));
    TRY(TAKE(a.match, (size_t)nshape));
    *out = a;
    a = (fit_answer){0};

done:
    fit_answer_free(&a);
    return st;
}

status fit_match_make(int nstation, fit_match *out)
{
    status st = OK;
    const size_t n = (size_t)nstation;
    out->nstation = nstation;
    TRY(TAKE(out->s, n));
    TRY(TAKE(out->before, n));
    TRY(TAKE(out->after, n));

done:
    return st;
}

void fit_answer_free(fit_answer *a)
{
    for (int k = 0; k < a->nshape && a->match; k++) {
        free(a->match[k].s);
        free(a->match[k].before);
        free(a->match[k].after);
    }
    free(a->value);
    free(a->error);
    free(a->low);
    free(a->high);
    free(a->bound);
    free(a->beyond);
    free(a->correlation);
    free(a->match);
    *a = (fit_answer){0};
}
