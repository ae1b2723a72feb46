// rodsolver/equilibrium_newton.c
// Newton's method on the whole rod at one factor of the loads, the tensions of pulled tendons among
// the unknowns. docs/theory.md (4.21)
#include "rodsolver/collocation.h"
#include "rodsolver/equilibrium.h"

#include <math.h>
#include <string.h>

double newton_size(const equilibrium *e, const vec6 *strain)
{
    const plan *p = e->plan;
    const double length = e->rod->length;
    double sum = 0;
    for (int i = 0; i < p->nstation; i++) {
        const double *x = strain[i].a;
        const double v2 = x[0] * x[0] + x[1] * x[1] + x[2] * x[2];
        const double w2 = x[3] * x[3] + x[4] * x[4] + x[5] * x[5];
        sum += gauss_weight[i % GAUSS_STATIONS] * panel_length(p, i / GAUSS_STATIONS) *
               (sqrt(v2) / length + sqrt(w2));
    }
    return sum;
}

// --- one step

bool newton_linearize(equilibrium *e)
{
    balance_poses(e);
    if (e->friction) {
        balance_friction(e);
    }
    balance_wrenches(e, e->line, e->node);
    if (!balance_stations(e, true) || !sweep_factor(e)) {
        return false;
    }
    if (pull_unknown(e)) {
        pull_factor(e);
    }
    return true;
}

static void present_misfits(equilibrium *e)
{
    for (int i = 0; i < e->plan->nstation; i++) {
        e->rv[i] = e->state[i].rv;
        e->rw[i] = e->state[i].rw;
    }
}

// what a linear answer with friction may leave out: below what the tangent leaves, and sharper for
// the way's slope, that tells limit points
static const double step_left = 1e-5, slope_left = 1e-8;

void newton_step(equilibrium *e)
{
    if (pull_unknown(e)) {
        balance_lengths(e, e->length);
        for (int i = 0; i < e->rod->ntendon; i++) {
            e->tension_step[i] = (e->pulled[i] && !e->slack[i]) ? -pull_excess(e, i) : 0;
        }
    }
    present_misfits(e);
    if (!friction_solve(e, step_left, e->tension_step, e->step)) {
        e->step[0].a[0] = NAN; // no step
    }
}

// a tendon keeps this part of its length in one step, and no rod turns more than this [rad]
static const double keep = 0.2, most_turn = 3;

double newton_longest_share(const equilibrium *e)
{
    const plan *p = e->plan;
    double share = fmin(1, most_turn / newton_size(e, e->step));
    for (int j = 0; j < e->rod->ntendon; j++) {
        const plan_tendon *t = &p->tendon[j];
        for (int i = 0; e->tension[j] > 0 && i < t->nstation; i++) {
            const vec3 d = tendon_direction(&t->place[i], &e->xi[i]);
            tendon_place straight = t->place[i];
            straight.dx = straight.dy = 0;
            const vec3 change = tendon_direction(&straight, &e->step[i]);
            const double shrink = -vec3_dot(d, change) / vec3_dot(d, d);
            share = shrink * share > 1 - keep ? (1 - keep) / shrink : share;
        }
    }
    return share;
}

void newton_advance(equilibrium *e, double share, const vec6 *step, const double *tension_step)
{
    for (int i = 0; i < e->plan->nstation; i++) {
        for (int c = 0; c < 6; c++) {
            e->xi[i].a[c] += share * step[i].a[c];
        }
    }
    for (int i = 0; i < e->rod->ntendon; i++) {
        if (e->pulled[i] && !e->slack[i]) {
            e->tension[i] += share * tension_step[i];
        }
    }
}

// what is left after a step: the square where the tangent is exact, and this part of it at least,
// by which the tangent of the collocation differs from the collocation's ...
static const double tangent_error = 1e-3;
// ... and after the first step this times its square
static const double first_square = 2;

static double left_over(double size, double before)
{
    if (before == HUGE_VAL) {
        return size * fmax(first_square * size, tangent_error);
    }
    const double rate = size / before;
    return size * fmax(rate * rate, tangent_error);
}

bool newton_correct(equilibrium *e, double tolerance, int most, double *moved)
{
    double before = HUGE_VAL;
    int growths = 0;
    *moved = 0;
    for (int k = 0; k < most; k++) {
        if (!newton_linearize(e)) {
            return false;
        }
        newton_step(e);
        e->iterations++;
        const double size = newton_size(e, e->step);
        if (!isfinite(size)) {
            return false;
        }
        const double share = newton_longest_share(e);
        newton_advance(e, share, e->step, e->tension_step);
        *moved += share * size;
        bool changed = false;
        if (pull_any(e)) {
            balance_lengths(e, e->length);
            changed = pull_update_slack(e);
        }
        growths += size > before;
        if (growths > 1) {
            return false;
        }
        if (!changed && share == 1 && (size <= tolerance || left_over(size, before) <= tolerance)) {
            return true;
        }
        before = changed ? HUGE_VAL : size;
    }
    return false;
}

// --- along the way

void newton_sum_misfits(equilibrium *e)
{
    // the wrenches are linear in the sums: those of the difference alone, at this shape
    for (int i = 0; i < e->plan->nstation; i++) {
        e->rv[i] = e->state[i].N;
        e->rw[i] = e->state[i].M;
    }
    balance_wrenches(e, e->line_difference, e->node_difference);
    for (int i = 0; i < e->plan->nstation; i++) {
        station_state *s = &e->state[i];
        const vec3 N = s->N, M = s->M;
        s->N = e->rv[i];
        s->M = e->rw[i];
        e->rv[i] = vec3_scale(-1, N);
        e->rw[i] = vec3_scale(-1, M);
        e->load_rate[i] = e->rv[i];
    }
}

void newton_load_misfits(equilibrium *e)
{
    newton_sum_misfits(e);
    for (int i = 0; i < e->rod->ntendon; i++) {
        const double change = e->to.tension[i] - e->from.tension[i];
        if (!e->pulled[i] && change != 0) {
            pull_misfit(e, i, change);
        }
    }
}

void newton_slope(equilibrium *e)
{
    const int n = e->rod->ntendon;
    newton_load_misfits(e);
    for (int i = 0; i < n; i++) {
        e->tension_slope[i] = e->pulled[i] ? e->from.pull[i] - e->to.pull[i] : 0;
    }
    // where it is not found, what there is predicts well enough
    friction_solve(e, slope_left, e->tension_slope, e->slope);
}
