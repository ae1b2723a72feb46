// measure/shape_fit.c
#include "measure/shape_fit.h"

#include "base/memory.h"
#include "measure/fit_inside.h"
#include "measure/fit_spread.h"

#include <math.h>
#include <string.h>

// Fits in turn with what the residuals tell of the errors: the third changes little.
enum { ROUNDS = 3 };
// Searches that end nearer to one another than this part of the range ended at the same place.
static const double same_place = 1e-3;

// --- one search

// where a coordinate stands beyond its bounds, in parts of the range; 0: between
static double outside(const fit *f, const double *z, int k)
{
    const int u = f->free[k];
    const fit_unknown *own = &f->problem->unknown[u];
    const double x = own->start + f->scale[u] * z[k];
    const double off = x < own->lower ? x - own->lower : x > own->upper ? x - own->upper : 0;
    return off / f->scale[u];
}

// the k-th of the free ones stays at its bound from now on
static void hold(fit *f, int k, double *z, fit_spread *spread)
{
    const int u = f->free[k];
    const fit_unknown *own = &f->problem->unknown[u];
    const double x = own->start + f->scale[u] * z[k];
    spread->bound[u] = x < own->lower ? -1 : 1;
    spread->beyond[u] = x;
    f->x[u] = x < own->lower ? own->lower : own->upper;
    for (int i = k; i + 1 < f->nfree; i++) {
        f->free[i] = f->free[i + 1];
    }
    for (int i = k; i + 1 < fit_nz(f); i++) {
        z[i] = z[i + 1];
    }
    f->nfree--;
    f->derived = false;
}

static void set_free(fit *f)
{
    for (int i = 0; i < f->problem->nunknown; i++) {
        f->free[i] = i;
    }
    f->nfree = f->problem->nunknown;
    f->derived = false;
}

// From z [nunknown + base] to the best place between the bounds. An unknown that the data alone
// would have beyond its bound is held there, and the others are searched again.
static status search_between(fit *f, double *z, double *cost, fit_spread *spread)
{
    status st = OK;
    set_free(f);
    for (int u = 0; u < f->problem->nunknown; u++) {
        spread->bound[u] = 0;
        spread->beyond[u] = NAN;
    }
    for (int left = f->nfree; left >= 0; left--) {
        int worst = -1;
        if (fit_nz(f) > 0) {
            TRY(fit_search(f, z, cost));
        }
        for (int k = 0; k < f->nfree; k++) {
            if (outside(f, z, k) != 0 &&
                (worst < 0 || fabs(outside(f, z, k)) > fabs(outside(f, z, worst)))) {
                worst = k;
            }
        }
        if (worst < 0) {
            break;
        }
        TRY(fit_spread_held(f, z, worst, spread));
        hold(f, worst, z, spread);
    }
    for (int k = 0; k < f->nfree; k++) {
        const int u = f->free[k];
        f->x[u] = f->problem->unknown[u].start + f->scale[u] * z[k];
    }

done:
    return st;
}

// --- several searches

typedef struct ending {
    double x[FIT_MOST_UNKNOWNS], cost;
} ending;

static bool same(const fit *f, const ending *a, const ending *b)
{
    bool all = true;
    for (int u = 0; u < f->problem->nunknown; u++) {
        all = all && fabs(a->x[u] - b->x[u]) <= same_place * f->scale[u];
    }
    return all;
}

// the search's coordinates of values, the base where it is taken to be
static void set_start(const fit *f, const double *x, double *z)
{
    const int n = f->problem->nunknown;
    memset(z, 0, (size_t)(n + 6 * f->nbase) * sizeof *z);
    for (int u = 0; u < n; u++) {
        z[u] = (x[u] - f->problem->unknown[u].start) / f->scale[u];
    }
}

static void random_start(const fit_problem *p, const gsl_random_door *door, gsl_random *random,
                         double *x)
{
    for (int u = 0; u < p->nunknown; u++) {
        const fit_unknown *own = &p->unknown[u];
        const double part = door->uniform(random);
        x[u] = isfinite(own->lower) && isfinite(own->upper)
                   ? own->lower + part * (own->upper - own->lower)
                   : own->start;
    }
}

static void count_endings(const fit *f, int n, const ending *end, const ending *best,
                          fit_answer *out)
{
    out->nstart = f->problem->nstart;
    out->nended = n;
    out->nsame = 0;
    out->next_chi2 = NAN;
    for (int i = 0; i < n; i++) {
        if (same(f, &end[i], best)) {
            out->nsame++;
        } else if (!(out->next_chi2 <= end[i].cost)) {
            out->next_chi2 = end[i].cost;
        }
    }
}

static status search_all(fit *f, double *z, fit_spread *spread, fit_answer *out)
{
    status st = OK;
    const gsl_random_door *door = NULL;
    gsl_random *random = NULL;
    ending *end = NULL;
    const fit_problem *p = f->problem;
    int n = 0, best = 0;
    TRY(TAKE(end, (size_t)p->nstart));
    TRY(gsl_random_door_open(&door));
    TRY(door->make(p->seed, &random));
    for (int i = 0; i < p->nstart; i++) {
        double x[FIT_MOST_UNKNOWNS];
        random_start(p, door, random, x);
        for (int u = 0; u < p->nunknown && i == 0; u++) {
            x[u] = p->unknown[u].start;
        }
        set_start(f, x, z);
        f->start = i;
        f->named = false;
        st = search_between(f, z, &end[n].cost, spread);
        if (st == ERR_NUMERIC && n == 0 && (i + 1 == p->nstart || fit_in_vain(f))) {
            TRY(fit_no_search_ended(f, i + 1));
        }
        if (st == ERR_NUMERIC) {
            status_clear(); // no way from there
            st = OK;
            continue;
        }
        TRY(st);
        memcpy(end[n].x, f->x, (size_t)p->nunknown * sizeof *f->x);
        best = end[n].cost < end[best].cost ? n : best;
        n++;
    }
    count_endings(f, n, end, &end[best], out);
    set_start(f, end[best].x, z);

done:
    if (door) {
        door->free(random);
    }
    free(end);
    return st;
}

// --- how the shapes fit

static double distance(const fit_station *t, const pose *g, vec3 q)
{
    const vec3 off = vec3_sub(vec3_add(mat3_mul_vec(g->R, q), g->p), t->at);
    return hypot(vec3_dot(t->across[0], off), vec3_dot(t->across[1], off));
}

static status make_matches(const fit *f, fit_answer *out)
{
    status st = OK;
    for (int k = 0; k < f->problem->nshape; k++) {
        int n = 0;
        for (int i = 0; i < f->nall; i++) {
            n += f->all[i].shape == k;
        }
        TRY(fit_match_make(n, &out->match[k]));
    }

done:
    return st;
}

// which: 0 before, 1 after
static void fill_matches(const fit *f, const double *z, int which, fit_answer *out)
{
    int shape = -1, k = 0;
    for (int i = 0; i < f->nall; i++) {
        const fit_station *t = &f->all[i];
        k = t->shape == shape ? k + 1 : 0;
        shape = t->shape;
        const pose g = z ? fit_base_pose(f, z, shape) : pose_identity();
        fit_match *m = &out->match[shape];
        m->s[k] = t->s;
        (which ? m->after : m->before)[k] = distance(t, &g, f->q[i]);
    }
    for (shape = 0; shape < f->problem->nshape; shape++) {
        const centreline *line = f->problem->shape[shape].line;
        const pose g = z ? fit_base_pose(f, z, shape) : pose_identity();
        fit_match *m = &out->match[shape];
        double sum = 0;
        for (int i = 0; i < m->nstation; i++) {
            const double d = which ? m->after[i] : m->before[i];
            sum += d * d;
        }
        m->rms[which] = sqrt(sum / m->nstation);
        const vec3 tip = vec3_add(mat3_mul_vec(g.R, f->tip[shape]), g.p);
        m->tip[which] = f->problem->shape[shape].to_tip
                            ? vec3_norm(vec3_sub(tip, line->p[line->count - 1]))
                            : NAN;
        const vec3 turn = so3_log(g.R);
        m->base = (vec6){{g.p.a[0], g.p.a[1], g.p.a[2], turn.a[0], turn.a[1], turn.a[2]}};
    }
}

static status look_before(fit *f, fit_answer *out)
{
    status st = OK;
    double x[FIT_MOST_UNKNOWNS];
    for (int u = 0; u < f->problem->nunknown; u++) {
        x[u] = f->problem->unknown[u].start;
    }
    TRY(fit_solve(f, x));
    fill_matches(f, NULL, 0, out);

done:
    return st;
}

// --- all of it

static status enough_data(const fit *f)
{
    const int n = f->problem->nunknown;
    if (2 * f->nuse <= n) {
        return status_fail(ERR_INPUT, "%d parameters are more than %d measured places tell", n,
                           f->nuse);
    }
    return OK;
}

static status rounds(fit *f, fit_answer *out)
{
    status st = OK;
    fit_spread spread = {0};
    double *z = NULL, cost = 0;
    const int n = f->problem->nunknown;
    TRY(TAKE(z, (size_t)(n + 6 * f->nbase)));
    TRY(search_all(f, z, &spread, out));
    for (int i = 0; i < ROUNDS; i++) {
        f->stop.any = false;
        st = search_between(f, z, &cost, &spread);
        TRY(st == ERR_NUMERIC ? fit_no_search_ended(f, 1) : st);
        // the model at the end, and what its residuals tell
        TRY(fit_solve(f, f->x));
        if (i + 1 < ROUNDS) {
            double x[FIT_MOST_UNKNOWNS];
            memcpy(x, f->x, (size_t)n * sizeof *x);
            fit_learn(f, z);
            set_start(f, x, z);
        }
    }
    fill_matches(f, z, 1, out);
    TRY(fit_spread_find(f, z, cost, &spread, out));

done:
    free(z);
    return st;
}

status shape_fit(const fit_problem *problem, fit_answer *out)
{
    status st = OK;
    fit f = {0};
    fit_answer a = {0};
    if (problem->nunknown > FIT_MOST_UNKNOWNS) {
        return status_fail(ERR_INPUT, "%d parameters are more than %d", problem->nunknown,
                           FIT_MOST_UNKNOWNS);
    }
    TRY(fit_answer_make(problem->nunknown, problem->nshape, &a));
    TRY(fit_make(problem, &f));
    TRY(enough_data(&f));
    TRY(make_matches(&f, &a));
    TRY(look_before(&f, &a));
    TRY(rounds(&f, &a));
    *out = a;
    a = (fit_answer){0};

done:
    fit_answer_free(&a);
    fit_free(&f);
    return st;
}
