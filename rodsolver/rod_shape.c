// rodsolver/rod_shape.c
#include "rodsolver/equilibrium.h"

#include <math.h>

pose rod_pose_at(const rod_state *state, double s)
{
    const rod *r = state->rod;
    const plan *p = state->solved;
    const int pair = plan_pair_at(p, s);
    const double *edge = &p->pair_edge[2 * pair];
    const double t = 2 * (s - edge[0]) / (edge[1] - edge[0]);
    vec6 xi[PAIR_STATIONS];
    for (int i = 0; i < PAIR_STATIONS; i++) {
        xi[i] = station_gather(state->xi, p->nstation, PAIR_STATIONS * pair + i);
    }
    // the tip of the shape is the tip of the answer, to the last bit
    pose g = s == edge[1]
                 ? state->pair_pose[pair + 1]
                 : pose_mul(state->pair_pose[pair], lie_pair_pose((edge[1] - edge[0]) / 2, xi, t));
    if (p->frame) {
        centre_frame f;
        law_along_centre_frame(r->law, s, p->frame[PAIR_STATIONS * pair + (t > 1 ? 4 : 1)].phi, &f);
        g = pose_mul(r->base, pose_mul(g, pose_inverse(centre_frame_pose(&f))));
    }
    return pose_mul(state->base, g);
}

status rod_shape(const rod_state *state, int npoint, double *s, pose *out)
{
    if (!state->solved || npoint < 2) {
        return status_fail(ERR_BUG, "rod: a shape of %d points %s", npoint,
                           state->solved ? "needs at least two" : "before a solution");
    }
    const double length = state->rod->length;
    for (int i = 0; i < npoint; i++) {
        s[i] = i == npoint - 1 ? length : length * i / (npoint - 1);
        out[i] = rod_pose_at(state, s[i]);
    }
    return OK;
}

status rod_pose(const rod_state *state, double s, pose *out)
{
    if (!state->solved) {
        return status_fail(ERR_BUG, "rod: a pose is asked for before a solution");
    }
    *out = rod_pose_at(state, fmin(fmax(s, 0), state->rod->length));
    return OK;
}

// the strain over the reference by the polynomial through the pair's stations, at the geometric
// centre
static vec6 strain_between(const rod_state *state, double s)
{
    const plan *p = state->solved;
    const int pair = plan_pair_at(p, s);
    const double *edge = &p->pair_edge[2 * pair];
    double weight[PAIR_STATIONS];
    lie_pair_weights(2 * (s - edge[0]) / (edge[1] - edge[0]), weight);
    vec6 sum = {{0}};
    for (int j = 0; j < PAIR_STATIONS; j++) {
        const int i = PAIR_STATIONS * pair + j;
        vec6 e = vec6_sub(station_gather(state->xi, p->nstation, i),
                          station_gather(p->rest, p->nstation, i));
        if (p->frame) {
            e = mat6_mul_vec(se3_adjoint(centre_frame_pose(&p->frame[i])), e);
        }
        sum = vec6_add(sum, vec6_scale(weight[j], e));
    }
    return sum;
}

// less than at the base by friction
// an arclength this near to a tendon's end is its end
static const double end_rounding = 1e-12;

static double tension_at(const rod_state *state, int tendon, double s)
{
    const plan *p = state->solved;
    const double *decay = state->by_load ? equilibrium_decay(state->loaded, tendon) : NULL;
    if (!decay) {
        return state->tension[tendon];
    }
    // at its very end: the pair before that, behind which there is no tendon
    const int pair = plan_pair_at(p, fmin(s, (1 - end_rounding) * state->rod->spec[tendon].end));
    const double *edge = &p->pair_edge[2 * pair];
    double weight[PAIR_STATIONS], sum = 0;
    lie_pair_weights(2 * (s - edge[0]) / (edge[1] - edge[0]), weight);
    for (int j = 0; j < PAIR_STATIONS; j++) {
        sum += weight[j] * decay[PAIR_STATIONS * pair + j];
    }
    return state->tension[tendon] * sum;
}

status rod_strain_at(const rod_state *state, double s, vec6 *xi)
{
    const rod *r = state->rod;
    if (!state->solved) {
        return status_fail(ERR_BUG, "rod: a strain is asked for before a solution");
    }
    const double clipped = fmin(fmax(s, 0), r->length);
    const int pair = plan_pair_at(state->solved, clipped);
    const double *edge = &state->solved->pair_edge[2 * pair];
    mat6 K;
    local_problem q = {.K = &K, .tendon = state->local.tendon};
    station_law(r, clipped, NULL, &K, &q.rest);
    const vec6 rest = q.rest;
    if (state->by_load) {
        // a wrench given moves the minimum to the strain that it makes alone
        mat6 lower;
        if (!mat6_cholesky(K, &lower)) {
            return status_fail(ERR_NUMERIC, "rod: the stiffness at s = %.6g mm", 1e3 * clipped);
        }
        const vec6 wrench = equilibrium_wrench_at(state, clipped);
        q.rest = vec6_add(q.rest, mat6_cholesky_solve(&lower, wrench));
    }
    for (int j = 0; j < state->nactive; j++) {
        const int i = state->active[j];
        if (state->solved->tendon[i].nstation <= PAIR_STATIONS * pair) {
            continue; // ends before
        }
        routing path;
        routing_make(&r->spec[i], &r->path[i], edge[0], edge[1], &path);
        q.tendon[q.ntendon++] = (local_tendon){.place = routing_at(&path, clipped),
                                               .tension = tension_at(state, i, clipped)};
    }
    *xi = state->by_load ? vec6_add(rest, strain_between(state, clipped)) : q.rest;
    if (q.ntendon == 0) {
        *xi = q.rest;
    }
    int steps = 0, which = 0;
    if (q.ntendon > 0 && local_solve(&q, xi, &steps, &which) != LOCAL_SOLVED) {
        return status_fail(ERR_NUMERIC, "rod: no strain at s = %.6g mm under these tensions",
                           1e3 * clipped);
    }
    return OK;
}

status rod_wrench_at(const rod_state *state, double s, vec6 *wrench, double *tension)
{
    status st = OK;
    const rod *r = state->rod;
    const double clipped = fmin(fmax(s, 0), r->length);
    vec6 xi, rest;
    mat6 K;
    TRY(rod_strain_at(state, clipped, &xi));
    station_law(r, clipped, NULL, &K, &rest);
    *wrench = mat6_mul_vec(K, vec6_sub(xi, rest));
    for (int i = 0; tension && i < r->ntendon; i++) {
        tension[i] =
            clipped <= (1 + end_rounding) * r->spec[i].end ? tension_at(state, i, clipped) : 0;
    }

done:
    return st;
}
