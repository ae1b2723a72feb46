// rodsolver/equilibrium_friction.c
// Coulomb friction along the tendons' paths while they pull: tau' = -mu tau |(R t)'|, so that
// tau(s) = tau(0) exp(-mu times the angle that the path has turned). docs/theory.md (4.26)
#include "rodsolver/collocation.h"
#include "rodsolver/equilibrium.h"

#include <math.h>

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
