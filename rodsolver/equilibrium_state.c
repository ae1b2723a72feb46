// rodsolver/equilibrium_state.c
// Between an equilibrium and the state that keeps answers.
#include "rodsolver/equilibrium.h"

#include <math.h>
#include <string.h>

void equilibrium_load_answer(equilibrium *e, const rod_state *state)
{
    const plan *p = state->solved;
    for (int i = 0; i < p->nstation; i++) {
        e->xi[i] = station_gather(state->xi, p->nstation, i);
    }
    e->factor = 0;
    equilibrium_use_plan(e, p);
    balance_lengths(e, e->length);
    if (e->friction) {
        balance_friction(e);
    }
    for (int i = 0; i < e->rod->ntendon; i++) {
        e->tension[i] = e->from.tension[i];
        e->slack[i] = e->pulled[i] && e->tension[i] == 0;
        if (e->pulled[i] && isnan(e->from.pull[i])) {
            e->from.pull[i] =
                e->rest_length[i] + pull_compliance(e, i) * e->tension[i] - e->length[i];
            e->slack[i] = false;
        }
    }
}

void equilibrium_store_answer(equilibrium *e, rod_state *state)
{
    const plan *p = e->plan;
    for (int i = 0; i < p->nstation; i++) {
        for (int c = 0; c < 6; c++) {
            state->xi[(size_t)c * (size_t)p->nstation + (size_t)i] = e->xi[i].a[c];
        }
    }
    for (int k = 0; k <= p->npair; k++) {
        state->pair_pose[k] = (pose){e->node_R[2 * k], e->node_p[2 * k]};
    }
    state->nactive = 0;
    for (int i = 0; i < e->rod->ntendon; i++) {
        state->tension[i] = e->tension[i];
        if (e->tension[i] > 0) {
            state->active[state->nactive++] = i;
        }
    }
    state->solved = p;
    state->by_load = true;
}

const double *equilibrium_decay(const equilibrium *e, int tendon)
{
    return e->friction ? e->decay + (size_t)tendon * (size_t)e->room : NULL;
}

void equilibrium_remember(rod_state *state)
{
    equilibrium *e = state->loaded;
    memset(e->pulled, 0, (size_t)e->rod->ntendon * sizeof *e->pulled);
    e->to.to_base = mat3_transpose(mat3_mul(state->base.R, e->rod->base.R));
    demand_nothing(e->rod, &e->to, &e->to);
    for (int i = 0; i < e->rod->ntendon; i++) {
        e->to.tension[i] = e->tension[i] = state->tension[i];
        e->to.pull[i] = NAN;
    }
}

status equilibrium_recall(rod_state *state)
{
    equilibrium *e = state->loaded;
    if (!state->solved) {
        return status_fail(ERR_BUG, "rod: derivatives are asked for before a solution");
    }
    if (state->by_load && state->at_limit) {
        return status_fail(ERR_NUMERIC, "rod: the answer is a limit point");
    }
    if (!state->by_load) {
        equilibrium_remember(state);
    }
    demand_copy(e->rod, &e->to, &e->from);
    memcpy(e->from.tension, state->tension, (size_t)e->rod->ntendon * sizeof *e->tension);
    memcpy(e->tension, state->tension, (size_t)e->rod->ntendon * sizeof *e->tension);
    demand_classify(e);
    // also those whose factor is 0: by it may be derived
    e->lines = e->rod->nline_load + e->rod->has_gravity > 0;
    equilibrium_load_answer(e, state);
    return OK;
}

status equilibrium_linearize(equilibrium *e)
{
    return newton_linearize(e) ? OK
                               : status_fail(ERR_NUMERIC, "rod: the answer is a critical point");
}

status equilibrium_resume(rod_state *state)
{
    status st = OK;
    TRY(equilibrium_recall(state));
    TRY(equilibrium_linearize(state->loaded));

done:
    return st;
}

static vec6 largest_strain(const equilibrium *e)
{
    const plan *p = e->plan;
    vec6 worst = {0};
    for (int i = 0; i < p->nstation; i++) {
        vec6 x = vec6_sub(e->xi[i], station_gather(p->rest, p->nstation, i));
        if (p->frame) {
            x = mat6_mul_vec(se3_adjoint(centre_frame_pose(&p->frame[i])), x);
        }
        for (int c = 0; c < 6; c++) {
            worst.a[c] = fmax(worst.a[c], fabs(x.a[c]));
        }
    }
    return worst;
}

void equilibrium_tell(equilibrium *e, const rod_state *state, double error, rod_solution *out)
{
    const rod *r = e->rod;
    const plan *p = e->plan;
    const pose tip = {e->node_R[2 * p->npair], e->node_p[2 * p->npair]};
    out->tip = pose_mul(state->base, pose_mul(r->base, pose_mul(tip, pose_inverse(r->tip))));
    out->iterations = e->iterations;
    out->relative_error = error;
    out->max_strain = largest_strain(e);
    out->stable = e->conservative ? e->negative == 0 : -1;
    out->eigenvalue = NAN;
    out->work = NAN;
    balance_check(e, &out->energy, &out->residual);
    if (out->tendon_length) {
        balance_lengths(e, out->tendon_length);
    }
    for (int i = 0; out->tension && i < r->ntendon; i++) {
        out->tension[i] = e->tension[i];
    }
}

void equilibrium_judge(rod_state *state, rod_solution *out)
{
    equilibrium *e = state->loaded;
    if (equilibrium_resume(state) != OK) {
        // at a critical point: the eigenvalue is 0 to rounding
        status_clear();
        out->eigenvalue = 0;
        return;
    }
    out->eigenvalue = energy_eigenvalue(e);
    out->work = energy_work(e);
    memcpy(e->tension, state->tension, (size_t)e->rod->ntendon * sizeof *e->tension);
    e->factor = 1;
    loads_at_factor(e);
}
