// rodsolver/rod_shape.c
#include "rodsolver/rod_plan.h"

#include <math.h>

static int pair_of(const plan *p, double s)
{
    int low = 0, high = p->npair;
    while (high - low > 1) {
        const int middle = (low + high) / 2;
        if (s < p->pair_edge[2 * middle]) {
            high = middle;
        } else {
            low = middle;
        }
    }
    return low;
}

// from the left end of the pair to t panel lengths further inside one panel: strains at the step's
// own Gauss points by the polynomial through the pair's six stations
static pose advance(const rod_state *state, const plan *p, int pair, double from, double to)
{
    const double h = (p->pair_edge[2 * pair + 1] - p->pair_edge[2 * pair]) / 2;
    vec6 xi[GAUSS_STATIONS];
    for (int i = 0; i < GAUSS_STATIONS; i++) {
        double weight[PAIR_STATIONS];
        lie_pair_weights(from + (to - from) * gauss_point[i], weight);
        for (int c = 0; c < 6; c++) {
            const double *row =
                state->xi + (size_t)c * (size_t)p->nstation + (size_t)(PAIR_STATIONS * pair);
            xi[i].a[c] = 0;
            for (int j = 0; j < PAIR_STATIONS; j++) {
                xi[i].a[c] += weight[j] * row[j];
            }
        }
    }
    return se3_exp(lie_step_twist((to - from) * h, xi));
}

static pose solved_pose_at(const rod_state *state, double s)
{
    const rod *r = state->rod;
    const plan *p = state->solved;
    const int pair = pair_of(p, s);
    const double *edge = &p->pair_edge[2 * pair];
    const double t = 2 * (s - edge[0]) / (edge[1] - edge[0]);
    pose g = state->pair_pose[pair];
    if (t > 1) {
        g = pose_mul(pose_mul(g, advance(state, p, pair, 0, 1)), advance(state, p, pair, 1, t));
    } else {
        g = pose_mul(g, advance(state, p, pair, 0, t));
    }
    if (p->frame) {
        centre_frame f;
        law_along_centre_frame(r->law, s, p->frame[PAIR_STATIONS * pair + (t > 1 ? 4 : 1)].phi, &f);
        g = pose_mul(pose_mul(r->base, g), pose_inverse(centre_frame_pose(&f)));
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
        out[i] = solved_pose_at(state, s[i]);
    }
    return OK;
}

status rod_strain_at(const rod_state *state, double s, vec6 *xi)
{
    const rod *r = state->rod;
    if (!state->solved) {
        return status_fail(ERR_BUG, "rod: a strain is asked for before a solution");
    }
    const double clipped = fmin(fmax(s, 0), r->length);
    const int pair = pair_of(state->solved, clipped);
    const double *edge = &state->solved->pair_edge[2 * pair];
    mat6 K;
    local_problem q = {.K = &K};
    station_law(r, clipped, NULL, &K, &q.rest);
    for (int j = 0; j < state->nactive; j++) {
        const int i = state->active[j];
        if (state->solved->tendon[i].nstation <= PAIR_STATIONS * pair) {
            continue; // ends before
        }
        routing path;
        routing_make(&r->spec[i], &r->path[i], edge[0], edge[1], &path);
        q.place[q.ntendon] = routing_at(&path, clipped);
        q.tension[q.ntendon++] = state->tension[i];
    }
    *xi = q.rest;
    int steps = 0, which = 0;
    if (q.ntendon > 0 && local_solve(&q, xi, &steps, &which) != LOCAL_SOLVED) {
        return status_fail(ERR_NUMERIC, "rod: no strain at s = %.6g m under these tensions",
                           clipped);
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
        tension[i] = clipped <= r->spec[i].end ? state->tension[i] : 0;
    }

done:
    return st;
}
