// rodsolver/rod_solve.c
#include "rodsolver/chain.h"
#include "rodsolver/equilibrium.h"
#include "rodsolver/stations.h"

#include <math.h>

static const char *tendon_name(const rod *r, int i)
{
    return r->spec[i].name ? r->spec[i].name : "?";
}

status solve_on_plan(rod_state *state, const plan *p, rod_solution *out)
{
    status st = OK;
    const rod *r = state->rod;
    out->iterations = 0;
    state->solved = NULL;
    TRY(stations_solve(state, p, &out->iterations));
    state->warm = NULL;
    out->relative_error = chain_pairs(state, p);
    state->solved = p;
    out->tip = state->pair_pose[p->npair];
    if (p->frame) {
        out->tip = pose_mul(r->base, pose_mul(out->tip, pose_inverse(r->tip)));
    }

done:
    return st;
}

static bool all_finite(const double *a, int n)
{
    for (int i = 0; i < n; i++) {
        if (!isfinite(a[i])) {
            return false;
        }
    }
    return true;
}

// products of a rotation's columns are those of the axes to this, after many steps of a loop too
static const double orthogonal = 1e-6;

static bool is_rotation(const mat3 *R)
{
    const double(*a)[3] = R->a;
    bool good = true;
    for (int i = 0; i < 3; i++) {
        const double *x = a[i], *y = a[(i + 1) % 3];
        good = good && fabs(x[0] * x[0] + x[1] * x[1] + x[2] * x[2] - 1) <= orthogonal &&
               fabs(x[0] * y[0] + x[1] * y[1] + x[2] * y[2]) <= orthogonal;
    }
    const double volume = a[0][0] * (a[1][1] * a[2][2] - a[1][2] * a[2][1]) +
                          a[0][1] * (a[1][2] * a[2][0] - a[1][0] * a[2][2]) +
                          a[0][2] * (a[1][0] * a[2][1] - a[1][1] * a[2][0]);
    return good && volume > 0;
}

static status check_request(const rod *r, const rod_request *q)
{
    if (!all_finite(q->tip_space.a, 6) || !all_finite(q->tip_body.a, 6)) {
        return status_fail(ERR_INPUT, "rod: the wrench on the tip is not finite");
    }
    if (q->base && !all_finite(q->base->p.a, 3)) {
        return status_fail(ERR_INPUT, "rod: the place of the base is not finite");
    }
    if (q->base && !is_rotation(&q->base->R)) {
        return status_fail(ERR_INPUT, "rod: the axes of the base are no rotation");
    }
    if (q->load && !all_finite(q->load, rod_load_count(r))) {
        return status_fail(ERR_INPUT, "rod: a factor of a load is not finite");
    }
    for (int i = 0; q->pull && i < r->ntendon; i++) {
        if (isinf(q->pull[i])) {
            return status_fail(ERR_INPUT, "rod: the pulled length of tendon '%s' is not finite",
                               tendon_name(r, i));
        }
    }
    return OK;
}

static double tension_asked(const rod_request *q, int i)
{
    return !q->tension || (q->pull && !isnan(q->pull[i])) ? 0 : q->tension[i];
}

// a tendon whose pulled length is given pulls as hard as that needs
static status take_tensions(rod_state *state, const rod_request *q)
{
    const rod *r = state->rod;
    state->nactive = 0;
    for (int i = 0; i < r->ntendon; i++) {
        const double tension = tension_asked(q, i);
        if (!(tension >= 0) || !isfinite(tension)) {
            return status_fail(ERR_INPUT,
                               "rod: tension of tendon '%s' is %g N, tendons cannot push",
                               tendon_name(r, i), tension);
        }
        state->tension[i] = tension;
        if (tension > 0) {
            state->active[state->nactive++] = i;
        }
    }
    return OK;
}

// whether anything acts besides tensions that stay the same along their tendons
static bool stations_depend_on_each_other(const rod *r, const rod_request *q)
{
    for (int c = 0; c < 6; c++) {
        if (q->tip_space.a[c] != 0 || q->tip_body.a[c] != 0) {
            return true;
        }
    }
    for (int i = 0; i < rod_load_count(r); i++) {
        if (r->acts[i] && !(q->load && q->load[i] == 0)) {
            return true;
        }
    }
    for (int i = 0; i < r->ntendon; i++) {
        if ((q->pull && !isnan(q->pull[i])) ||
            (r->spec[i].friction > 0 && tension_asked(q, i) > 0)) {
            return true;
        }
    }
    return false;
}

// by the share of the critical tension, so that the answer does not depend on what was solved
// before
static int first_plan(const rod_state *state)
{
    const rod *r = state->rod;
    const plan *p = &r->plans[r->nplan - 1];
    double share = 0;
    for (int i = 0; i < r->ntendon; i++) {
        share += state->tension[i] / p->tendon[i].critical;
    }
    int k = 0;
    while (k < ROD_PROBES - 1 && share > rod_probe_share[k]) {
        k++;
    }
    return r->first_plan[k];
}

// the coarsest finer plan whose error should be half the tolerance at most
static int finer_plan(const rod *r, int k, double error)
{
    const double n = r->plans[k].npair;
    for (k++; k < r->nplan - 1; k++) {
        if (error * pow(n / r->plans[k].npair, 6) < r->options.tolerance / 2) {
            break;
        }
    }
    return k;
}

static status solve_stationwise(rod_state *state, rod_solution *out)
{
    status st = OK;
    const rod *r = state->rod;
    const bool fixed = r->options.npanel > 0;
    int k = fixed ? 0 : first_plan(state), steps = 0;
    for (;;) {
        TRY(solve_on_plan(state, &r->plans[k], out));
        steps += out->iterations;
        if (fixed || out->relative_error <= r->options.tolerance) {
            break;
        }
        if (k == r->nplan - 1) {
            state->solved = NULL;
            TRY(status_fail(
                ERR_NUMERIC,
                "rod: the estimated error of the tip, %.2g of the length, stays above the "
                "tolerance %.2g with %d panels",
                out->relative_error, r->options.tolerance, 2 * r->plans[k].npair));
        }
        k = finer_plan(r, k, out->relative_error);
    }
    out->iterations = steps;

done:
    return st;
}

static void tell(const rod_state *state, rod_solution *out)
{
    out->limited = false;
    out->fraction = 1;
    out->stable = 1; // the energy is convex: docs/theory.md (4.3)
    out->eigenvalue = NAN;
    out->ncritical = 0;
    stations_check(state, state->solved, out);
    out->work = out->energy;
    if (out->tendon_length) {
        stations_lengths(state, state->solved, out->tendon_length);
    }
    for (int i = 0; out->tension && i < state->rod->ntendon; i++) {
        out->tension[i] = state->tension[i];
    }
}

static status solve(rod_state *state, const rod_request *request, bool told, rod_solution *out)
{
    status st = OK;
    TRY(check_request(state->rod, request));
    const bool coupled = stations_depend_on_each_other(state->rod, request);
    if (coupled && state->solved && !state->by_load) {
        equilibrium_remember(state);
    }
    TRY(take_tensions(state, request));
    state->base = request->base ? *request->base : pose_identity();
    if (coupled) {
        return equilibrium_solve(state, request, out);
    }
    state->warm = !request->cold && !state->by_load ? state->solved : NULL;
    state->by_load = state->at_limit = false;
    TRY(solve_stationwise(state, out));
    out->tip = request->base ? pose_mul(state->base, out->tip) : out->tip;
    if (told) {
        tell(state, out);
        if (request->stability) {
            equilibrium_judge(state, out);
        }
    }

done:
    if (st != OK) {
        state->solved = NULL;
    }
    return st;
}

status rod_solve(rod_state *state, const rod_request *request, rod_solution *out)
{
    return solve(state, request, true, out);
}

status rod_solve_tip(rod_state *state, const rod_request *request, rod_solution *out)
{
    return solve(state, request, false, out);
}
