// rodsolver/equilibrium_friction.c
// Coulomb friction along the tendons' paths while they pull: tau' = -mu tau |(R t)'|, so that
// tau(s) = tau(0) exp(-mu times the angle that the path has turned). docs/theory.md (4.26)
#include "rodsolver/collocation.h"
#include "rodsolver/equilibrium.h"

#include <math.h>
#include <string.h>

enum { FOLLOWS = 60 };

// turn of the rod by which the tensions' derivatives are differenced
static const double probe = 1e-5;
// part of a derivative that is left out
static const double followed = 1e-10;

// the derivative of the polynomial through a pair's six stations, at them, per panel length
static void pair_slopes(double D[PAIR_STATIONS][PAIR_STATIONS])
{
    double x[PAIR_STATIONS], w[PAIR_STATIONS];
    for (int i = 0; i < PAIR_STATIONS; i++) {
        x[i] = gauss_point[i % GAUSS_STATIONS] + i / GAUSS_STATIONS;
    }
    for (int i = 0; i < PAIR_STATIONS; i++) {
        w[i] = 1;
        for (int j = 0; j < PAIR_STATIONS; j++) {
            w[i] *= j == i ? 1 : 1 / (x[i] - x[j]);
        }
    }
    for (int i = 0; i < PAIR_STATIONS; i++) {
        D[i][i] = 0;
        for (int j = 0; j < PAIR_STATIONS; j++) {
            if (j != i) {
                D[i][j] = w[j] / w[i] / (x[i] - x[j]);
                D[i][i] -= D[i][j];
            }
        }
    }
}

// how fast the tendon's tangent turns in space at each station of a pair: |w x t + t'|
static void turning_rates(const equilibrium *e, const plan_tendon *t, int pair,
                          const double D[PAIR_STATIONS][PAIR_STATIONS], double *rate)
{
    const double h = panel_length(e->plan, 2 * pair);
    const int first = PAIR_STATIONS * pair;
    vec3 tangent[PAIR_STATIONS];
    for (int i = 0; i < PAIR_STATIONS; i++) {
        const vec3 d = tendon_direction(&t->place[first + i], &e->xi[first + i]);
        tangent[i] = vec3_scale(1 / vec3_norm(d), d);
    }
    for (int i = 0; i < PAIR_STATIONS; i++) {
        const double *x = e->xi[first + i].a;
        vec3 turn = vec3_cross((vec3){{x[3], x[4], x[5]}}, tangent[i]);
        for (int j = 0; j < PAIR_STATIONS; j++) {
            turn = vec3_add(turn, vec3_scale(D[i][j] / h, tangent[j]));
        }
        rate[i] = vec3_norm(turn);
    }
}

static void follow_tendon(const equilibrium *e, int tendon,
                          const double D[PAIR_STATIONS][PAIR_STATIONS])
{
    const plan_tendon *t = &e->plan->tendon[tendon];
    const double mu = e->rod->spec[tendon].friction;
    double *decay = e->decay + (size_t)tendon * (size_t)e->room;
    double angle = 0;
    for (int pair = 0; PAIR_STATIONS * pair < t->nstation; pair++) {
        double rate[PAIR_STATIONS];
        const double h = panel_length(e->plan, 2 * pair);
        turning_rates(e, t, pair, D, rate);
        for (int k = 0; k < PAIR_STATIONS; k += GAUSS_STATIONS) {
            double end = angle;
            for (int i = 0; i < GAUSS_STATIONS; i++) {
                double here = angle;
                for (int j = 0; j < GAUSS_STATIONS; j++) {
                    here += h * gauss_inner[i][j] * rate[k + j];
                }
                decay[PAIR_STATIONS * pair + k + i] = exp(-mu * here);
                end += h * gauss_weight[i] * rate[k + i];
            }
            angle = end;
        }
    }
}

void balance_friction(equilibrium *e)
{
    double D[PAIR_STATIONS][PAIR_STATIONS];
    pair_slopes(D);
    for (int i = 0; i < e->rod->ntendon; i++) {
        follow_tendon(e, i, (const double(*)[PAIR_STATIONS])D);
    }
}

// --- derivatives

// adds what tensions along the paths change by when the strains change by e->step
static void add_friction(equilibrium *e, double *changed)
{
    const size_t n = (size_t)e->rod->ntendon * (size_t)e->room;
    const double step = probe / fmax(newton_size(e, e->step), 1e-300);
    memcpy(e->scratch, e->xi, (size_t)e->plan->nstation * sizeof *e->xi);
    for (int side = 1; side >= -1; side -= 2) {
        for (int i = 0; i < e->plan->nstation; i++) {
            e->xi[i] = vec6_add(e->scratch[i], vec6_scale(side * step, e->step[i]));
        }
        balance_friction(e);
        for (size_t i = 0; i < n; i++) {
            changed[i] = side > 0 ? e->decay[i] : (changed[i] - e->decay[i]) / (2 * step);
        }
    }
    memcpy(e->xi, e->scratch, (size_t)e->plan->nstation * sizeof *e->xi);
    balance_friction(e);
    for (int j = 0; j < e->rod->ntendon; j++) {
        for (int i = 0; e->tension[j] > 0 && i < e->plan->tendon[j].nstation; i++) {
            const double tau = e->tension[j] * changed[(size_t)j * (size_t)e->room + (size_t)i];
            const vec6 f = vec6_scale(tau, balance_tendon(e, j, i));
            const mat3 *R = &e->state[i].R;
            e->rv[i] = vec3_add(e->rv[i], mat3_mul_vec(*R, (vec3){{f.a[0], f.a[1], f.a[2]}}));
            e->rw[i] = vec3_add(e->rw[i], mat3_mul_vec(*R, (vec3){{f.a[3], f.a[4], f.a[5]}}));
        }
    }
}

void friction_solve(equilibrium *e, double *change, vec6 *strain)
{
    const size_t n = (size_t)e->plan->nstation, ntendon = (size_t)e->rod->ntendon;
    memcpy(e->arc_v, e->rv, n * sizeof *e->rv);
    memcpy(e->arc_w, e->rw, n * sizeof *e->rw);
    memcpy(e->arc_tension, change, ntendon * sizeof *change);
    pull_solve(e, change, e->step);
    for (int k = 0; k < FOLLOWS; k++) {
        memcpy(e->arc_step, e->step, n * sizeof *e->step);
        memcpy(e->rv, e->arc_v, n * sizeof *e->rv);
        memcpy(e->rw, e->arc_w, n * sizeof *e->rw);
        memcpy(change, e->arc_tension, ntendon * sizeof *change);
        add_friction(e, e->decay_change);
        pull_solve(e, change, e->step);
        for (size_t i = 0; i < n; i++) {
            e->arc_step[i] = vec6_sub(e->step[i], e->arc_step[i]);
        }
        if (newton_size(e, e->arc_step) <= followed * newton_size(e, e->step)) {
            break;
        }
    }
    if (strain != e->step) {
        memcpy(strain, e->step, n * sizeof *strain);
    }
}
