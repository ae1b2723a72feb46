// app/sensitivity_draw.c
// All parameters that have a range, drawn at random together; the solutions of every sample; what
// their spread is. docs/theory.md (9.58)
#include "app/sensitivity.h"
#include "base/memory.h"
#include "measure/gsl_door.h"
#include "measure/shares.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

// a normal draw that falls outside of low and high is drawn again, as often as this
enum { MOST_DRAWS = 1000, PROGRESS_STRIDE = 16 };

// of a solve's place, over the length, and of a bend [rad]
static const double rounding = 1e-10;

typedef struct samples {
    int n, ndrawn;
    int *drawn;     // [ndrawn] parameters
    double *x;      // [n][ndrawn] in units of the keys
    double *y;      // [nsolution][SPREAD_QUANTITIES][n]; NAN: no answer
    double *column; // [n][ndrawn] room: of the samples that have an answer, -1 to 1 or in sigmas
    double *value;  // [n] room
} samples;

static void samples_free(samples *a)
{
    free(a->drawn);
    free(a->x);
    free(a->y);
    free(a->column);
    free(a->value);
}

static status samples_make(sensitivity_study *s, samples *a)
{
    status st = OK;
    const sensitivity_result *r = s->out;
    a->n = s->c->file.sensitivity.monte_carlo.samples;
    TRY(TAKE(a->drawn, (size_t)r->nmover));
    for (int k = 0; k < r->nmover; k++) {
        mover *p = &r->mover[k];
        // an expression in s is no number that could be drawn about, but one may be drawn instead
        p->drawn = !p->discrete;
        if (p->drawn) {
            a->drawn[a->ndrawn++] = k;
        }
    }
    if (a->ndrawn == 0) {
        return config_fail(s->c->config, s->c->file.sensitivity.monte_carlo.at,
                           "no parameter has a range to draw from");
    }
    const size_t n = (size_t)a->n;
    TRY(TAKE(a->x, n * (size_t)a->ndrawn));
    TRY(TAKE(a->column, n * (size_t)a->ndrawn));
    TRY(TAKE(a->value, n));
    TRY(TAKE(a->y, n * (size_t)r->nsolution * SPREAD_QUANTITIES));

done:
    return st;
}

// --- drawing

static double draw_one(const gsl_random_door *door, gsl_random *g, const mover *p)
{
    const double low = p->end[MOVER_LOW].value, high = p->end[MOVER_HIGH].value;
    return p->sigma > 0 ? p->value + p->sigma * door->normal(g)
                        : low + (high - low) * door->uniform(g);
}

static status draw(const sensitivity_study *s, const gsl_random_door *door, gsl_random *g,
                   const samples *a)
{
    for (int i = 0; i < a->n * a->ndrawn; i++) {
        const int k = a->drawn[i % a->ndrawn];
        const mover *p = &s->out->mover[k];
        const bool cut = p->sigma > 0 && !isnan(s->parameter[k].low);
        int tries = 0;
        do {
            a->x[i] = draw_one(door, g, p);
        } while (cut && tries++ < MOST_DRAWS &&
                 !(a->x[i] >= p->end[MOVER_LOW].value && a->x[i] <= p->end[MOVER_HIGH].value));
        if (tries > MOST_DRAWS) {
            return config_fail(s->c->config, s->parameter[k].p.at,
                               "parameter '%.60s': its normal distribution hardly ever falls "
                               "between low and high",
                               p->name);
        }
    }
    return OK;
}

// --- solving

static double *quantity(const samples *a, int solution, int q)
{
    return &a->y[((size_t)solution * SPREAD_QUANTITIES + (size_t)q) * (size_t)a->n];
}

static status keep_answer(const sensitivity_study *s, const samples *a, int sample,
                          const variation_answer *answer, double *bend)
{
    sensitivity_bends(answer, bend);
    for (int i = 0; i < answer->nsolution; i++) {
        const vec3 p = answer->tip[i].p;
        const double off = vec3_norm(vec3_sub(p, s->base.tip[i].p));
        const double values[SPREAD_QUANTITIES] = {p.a[0], p.a[1], p.a[2], off, bend[i]};
        for (int q = 0; q < SPREAD_QUANTITIES; q++) {
            // at a limit point the rod snaps: no answer of this sample
            quantity(a, i, q)[sample] = answer->fraction[i] < 1 ? NAN : values[q];
        }
    }
    return OK;
}

static void no_answer(const sensitivity_study *s, const samples *a, int sample)
{
    for (int i = 0; i < s->out->nsolution * SPREAD_QUANTITIES; i++) {
        a->y[(size_t)i * (size_t)a->n + (size_t)sample] = NAN;
    }
}

static status solve_sample(sensitivity_study *s, const samples *a, int sample, double *bend)
{
    status st = OK;
    settings with = {0};
    variation_answer answer = {0};
    for (int j = 0; j < a->ndrawn; j++) {
        TRY(settings_add(&with, &s->parameter[a->drawn[j]].p, a->x[sample * a->ndrawn + j]));
    }
    st = sensitivity_solve(s, &with, s->c->file.sensitivity.monte_carlo.at, &answer);
    if (st == ERR_NUMERIC || (st == ERR_INPUT && a->n > 1)) {
        no_answer(s, a, sample); // told as a sample without an answer
        status_clear();
        st = OK;
        goto done;
    }
    TRY(st);
    TRY(keep_answer(s, a, sample, &answer, bend));

done:
    variation_answer_free(&answer);
    settings_free(&with);
    return st;
}

static status solve_all(sensitivity_study *s, const samples *a)
{
    status st = OK;
    double *bend = NULL;
    TRY(TAKE(bend, (size_t)s->out->nsolution));
    for (int i = 0; i < a->n; i++) {
        if (i % PROGRESS_STRIDE == 0) {
            char words[64];
            (void)snprintf(words, sizeof words, "sensitivity: sample %d of %d", i + 1, a->n);
            command_progress(s->cmd, words);
        }
        TRY(solve_sample(s, a, i, bend));
    }

done:
    free(bend);
    return st;
}

// --- what the samples say

// samples of one quantity that have an answer, their parameters beside them; their count
static int gather(const sensitivity_study *s, const samples *a, const double *y)
{
    int n = 0;
    for (int i = 0; i < a->n; i++) {
        if (isnan(y[i])) {
            continue;
        }
        for (int j = 0; j < a->ndrawn; j++) {
            const mover *p = &s->out->mover[a->drawn[j]];
            const double low = p->end[MOVER_LOW].value, high = p->end[MOVER_HIGH].value;
            const double x = a->x[i * a->ndrawn + j];
            a->column[n * a->ndrawn + j] =
                p->sigma > 0 ? (x - p->value) / p->sigma : (2 * x - low - high) / (high - low);
        }
        a->value[n++] = y[i];
    }
    return n;
}

static status share_out(const sensitivity_study *s, const samples *a, int solution, int q)
{
    status st = OK;
    sensitivity_result *r = s->out;
    monte_carlo *m = &r->monte_carlo;
    double share[SENSITIVITY_PARAMETERS] = {0};
    const int n = gather(s, a, quantity(a, solution, q));
    m->used[solution] = n;
    sample_spread *out = &m->spread[solution * SPREAD_QUANTITIES + q];
    TRY(shares_of(n, a->ndrawn, a->column, a->value, m->degree, share, out));
    // what does not move has no variance to share out
    const bool still = out->deviation <= rounding * (q == SPREAD_BEND ? 1 : s->c->file.rod.length);
    out->rest = still ? NAN : out->rest;
    for (int j = 0; j < a->ndrawn; j++) {
        double *to = &m->share[(size_t)(solution * SPREAD_QUANTITIES + q) * (size_t)r->nmover];
        to[a->drawn[j]] = still ? NAN : share[j];
    }

done:
    return st;
}

static status tell(sensitivity_study *s, const samples *a)
{
    status st = OK;
    monte_carlo *m = &s->out->monte_carlo;
    TRY(monte_carlo_make(s->out, m));
    m->nsample = a->n;
    m->seed = s->c->file.sensitivity.monte_carlo.seed;
    m->degree = shares_degree(a->n, a->ndrawn);
    for (int i = 0; i < s->out->nsolution; i++) {
        for (int q = 0; q < SPREAD_QUANTITIES; q++) {
            TRY(share_out(s, a, i, q));
        }
    }

done:
    return st;
}

status sensitivity_monte_carlo(sensitivity_study *s)
{
    status st = OK;
    const gsl_random_door *door = NULL;
    gsl_random *g = NULL;
    samples a = {0};
    TRY(samples_make(s, &a));
    TRY(gsl_random_door_open(&door));
    TRY(door->make((unsigned long)s->c->file.sensitivity.monte_carlo.seed, &g));
    TRY(draw(s, door, g, &a));
    TRY(solve_all(s, &a));
    TRY(tell(s, &a));

done:
    if (door) {
        door->free(g);
    }
    samples_free(&a);
    return st;
}
