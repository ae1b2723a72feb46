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
static pose advance(const rod *r, const plan *p, int pair, double from, double to)
{
    const double h = (p->pair_edge[2 * pair + 1] - p->pair_edge[2 * pair]) / 2;
    vec6 xi[GAUSS_STATIONS];
    for (int i = 0; i < GAUSS_STATIONS; i++) {
        double weight[PAIR_STATIONS];
        lie_pair_weights(from + (to - from) * gauss_point[i], weight);
        for (int c = 0; c < 6; c++) {
            const double *row =
                r->xi + (size_t)c * (size_t)p->nstation + (size_t)(PAIR_STATIONS * pair);
            xi[i].a[c] = 0;
            for (int j = 0; j < PAIR_STATIONS; j++) {
                xi[i].a[c] += weight[j] * row[j];
            }
        }
    }
    return se3_exp(lie_step_twist((to - from) * h, xi));
}

static pose solved_pose_at(const rod *r, double s)
{
    const plan *p = r->solved;
    const int pair = pair_of(p, s);
    const double *edge = &p->pair_edge[2 * pair];
    const double t = 2 * (s - edge[0]) / (edge[1] - edge[0]);
    pose g = r->pair_pose[pair];
    if (t > 1) {
        g = pose_mul(pose_mul(g, advance(r, p, pair, 0, 1)), advance(r, p, pair, 1, t));
    } else {
        g = pose_mul(g, advance(r, p, pair, 0, t));
    }
    if (p->frame) {
        centre_frame f;
        law_along_centre_frame(r->law, s, p->frame[PAIR_STATIONS * pair + (t > 1 ? 4 : 1)].phi, &f);
        g = pose_mul(pose_mul(r->base, g), pose_inverse(centre_frame_pose(&f)));
    }
    return g;
}

status rod_shape(const rod *r, int npoint, double *s, pose *out)
{
    if (!r->solved || npoint < 2) {
        return status_fail(ERR_BUG, "rod: a shape of %d points %s", npoint,
                           r->solved ? "needs at least two" : "before a solution");
    }
    for (int i = 0; i < npoint; i++) {
        s[i] = i == npoint - 1 ? r->length : r->length * i / (npoint - 1);
        out[i] = solved_pose_at(r, s[i]);
    }
    return OK;
}

status rod_strain_at(const rod *r, double s, vec6 *xi)
{
    if (!r->solved) {
        return status_fail(ERR_BUG, "rod: a strain is asked for before a solution");
    }
    const double clipped = fmin(fmax(s, 0), r->length);
    const int pair = pair_of(r->solved, clipped);
    const double *edge = &r->solved->pair_edge[2 * pair];
    mat6 K;
    local_problem q = {.K = &K};
    station_law(r, clipped, NULL, &K, &q.rest);
    for (int j = 0; j < r->nactive; j++) {
        const int i = r->active[j];
        if (r->solved->tendon[i].nstation <= PAIR_STATIONS * pair) {
            continue; // ends before
        }
        routing path;
        routing_make(&r->spec[i], edge[0], edge[1], &path);
        q.place[q.ntendon] = routing_at(&path, clipped);
        q.tension[q.ntendon++] = r->tension[i];
    }
    *xi = q.rest;
    int steps = 0, which = 0;
    if (q.ntendon > 0 && local_solve(&q, xi, &steps, &which) != LOCAL_SOLVED) {
        return status_fail(ERR_NUMERIC, "rod: no strain at s = %.6g m under these tensions",
                           clipped);
    }
    return OK;
}
