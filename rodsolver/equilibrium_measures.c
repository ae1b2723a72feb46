// rodsolver/equilibrium_measures.c
// What an equilibrium is measured by: lengths of tendons, stored energy, the balance's misfit.
#include "rodsolver/equilibrium.h"

#include <math.h>

// a tendon this short where no more load is borne has eaten its own length
static const double all_but_eaten = 2e-3;

// a section this thin where no more load is borne is pressed to nothing
static const double all_but_pressed = 0.05;

bool balance_finds_eaten(const equilibrium *e, int *tendon, int *station)
{
    for (int j = 0; j < e->rod->ntendon; j++) {
        const plan_tendon *t = &e->plan->tendon[j];
        for (int i = 0; i < t->nstation; i++) {
            if (vec3_norm(tendon_direction(&t->place[i], &e->xi[i])) < all_but_eaten) {
                *tendon = j;
                *station = i;
                return true;
            }
        }
    }
    return false;
}

bool balance_finds_pressed(const equilibrium *e, int *station)
{
    for (int i = 0; i < e->plan->nstation; i++) {
        if (e->xi[i].a[2] < all_but_pressed) {
            *station = i;
            return true;
        }
    }
    return false;
}

void balance_lengths(equilibrium *e, double *length)
{
    const plan *p = e->plan;
    for (int j = 0; j < e->rod->ntendon; j++) {
        const plan_tendon *t = &p->tendon[j];
        length[j] = 0;
        for (int i = 0; i < t->nstation; i++) {
            length[j] += gauss_weight[i % GAUSS_STATIONS] * panel_length(p, i / GAUSS_STATIONS) *
                         vec3_norm(tendon_direction(&t->place[i], &e->xi[i]));
        }
    }
}

void balance_check(equilibrium *e, double *energy, double *residual)
{
    const plan *p = e->plan;
    double largest = 0, worst = 0;
    *energy = 0;
    balance_wrenches(e, e->line, e->node);
    if (!balance_stations(e, false)) {
        *residual = HUGE_VAL;
        return;
    }
    for (int i = 0; i < p->nstation; i++) {
        const station_state *s = &e->state[i];
        const vec6 strain = vec6_sub(e->xi[i], station_gather(p->rest, p->nstation, i));
        const double twice = vec6_dot(strain, mat6_mul_vec(p->K[i], strain));
        const vec3 f = mat3_tmul_vec(s->R, s->rv), m = mat3_tmul_vec(s->R, s->rw);
        const vec6 g = {{f.a[0], f.a[1], f.a[2], m.a[0], m.a[1], m.a[2]}};
        double misfit = 0;
        for (int c = 0; c < 6; c++) {
            misfit += g.a[c] * g.a[c] / p->K[i].a[c][c];
        }
        worst = fmax(worst, misfit);
        largest = fmax(largest, twice);
        *energy +=
            gauss_weight[i % GAUSS_STATIONS] * panel_length(p, i / GAUSS_STATIONS) * twice / 2;
    }
    *residual = largest > 0 ? sqrt(worst / largest) : 0;
}
