// rodsolver/chain.c
// The pose from the strains: a chain of exponentials over pairs of panels, and what it is off.
#include "rodsolver/chain.h"

#include <math.h>

// rounding of one panel's exponential and product, in units of the length it carries
static const double rounding = 2e-16;
// The local error of a step of order 6 is of degree 7: one of twice the length makes 2^7, the two
// fine ones 2, so that the coarse chain is 63 times as far off. Three times that, since plans may
// be too coarse to follow the law; and a share of all local differences without their signs, since
// those may cancel by chance at the tip
static const double doubled = 63;
static const double margin = 3, unsigned_share = 0.1;

// eight pairs: their motion in two steps, in one, and how far apart these carry the tip at most
typedef struct pair_block {
    lanes_pose fine, once;
    lanes misfit;
} pair_block;

// idle lanes repeat the last pair
static void load_pairs(const plan *p, const double *xi, int first, int count, lanes *half,
                       lanes out[PAIR_STATIONS][6])
{
    const size_t n = (size_t)p->nstation;
    for (int k = 0; k < LANES; k++) {
        const int pair = first + (k < count ? k : count - 1);
        (*half)[k] = (p->pair_edge[2 * pair + 1] - p->pair_edge[2 * pair]) / 2;
        const double *x = xi + PAIR_STATIONS * pair;
        for (size_t c = 0; c < 6; c++) {
            for (int i = 0; i < PAIR_STATIONS; i++) {
                out[i][c][k] = x[c * n + (size_t)i];
            }
        }
    }
}

LANES_INLINE void mul_lanes(const lanes_pose *g, const lanes_pose *h, lanes_pose *out)
{
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            out->R[i][j] =
                g->R[i][0] * h->R[0][j] + g->R[i][1] * h->R[1][j] + g->R[i][2] * h->R[2][j];
        }
        out->p[i] = g->p[i] + g->R[i][0] * h->p[0] + g->R[i][1] * h->p[1] + g->R[i][2] * h->p[2];
    }
}

// displacement, and the angle times the lever to the tip, which is at most the length that is left
LANES_INLINE void misfit_lanes(const lanes *lever, pair_block *b)
{
    const lanes zero = {0};
    lanes displacement = zero, angle = zero;
    for (int i = 0; i < 3; i++) {
        const lanes d = b->fine.p[i] - b->once.p[i];
        displacement += d * d;
        for (int j = 0; j < 3; j++) {
            const lanes e = b->fine.R[i][j] - b->once.R[i][j];
            angle += e * e;
        }
    }
    for (int k = 0; k < LANES; k++) {
        b->misfit[k] = sqrt(displacement[k]) + sqrt(angle[k] / 2) * (*lever)[k];
    }
}

// docs/theory.md (4.6), and on the same stations (4.8)
LANES_CODE static void step_pairs(const rod *r, const lanes *half, const lanes *lever,
                                  const lanes xi[PAIR_STATIONS][6], pair_block *b)
{
    lanes coarse[GAUSS_STATIONS][6];
    lanes_pose left, right;
    for (int i = 0; i < GAUSS_STATIONS; i++) {
        const double *w = r->pair_weight[i];
        for (int c = 0; c < 6; c++) {
            coarse[i][c] = w[0] * xi[0][c] + w[1] * xi[1][c] + w[2] * xi[2][c] + w[3] * xi[3][c] +
                           w[4] * xi[4][c] + w[5] * xi[5][c];
        }
    }
    const lanes whole = 2 * *half;
    lie_step_lanes(half, xi, &left);
    lie_step_lanes(half, xi + GAUSS_STATIONS, &right);
    lie_step_lanes(&whole, (const lanes(*)[6])coarse, &b->once);
    mul_lanes(&left, &right, &b->fine);
    misfit_lanes(lever, b);
}

static inline void mul_lane(const pose *g, const lanes_pose *h, int k, pose *out)
{
    const double x = h->p[0][k], y = h->p[1][k], z = h->p[2][k];
    for (int i = 0; i < 3; i++) {
        const double a = g->R.a[i][0], b = g->R.a[i][1], c = g->R.a[i][2];
        for (int j = 0; j < 3; j++) {
            out->R.a[i][j] = a * h->R[0][j][k] + b * h->R[1][j][k] + c * h->R[2][j][k];
        }
        out->p.a[i] = g->p.a[i] + a * x + b * y + c * z;
    }
}

// constant strain in every pair: one exponential each, exact
static double chain_uniform(rod_state *state, const plan *p)
{
    for (int k = 0; k < p->npair; k++) {
        const vec6 xi = station_gather(state->xi, p->nstation, PAIR_STATIONS * k);
        const double h = p->pair_edge[2 * k + 1] - p->pair_edge[2 * k];
        const pose step = se3_exp(vec6_scale(h, xi));
        state->pair_pose[k + 1] = k == 0 ? step : pose_mul(state->pair_pose[k], step);
    }
    return rounding * 2 * p->npair;
}

double chain_pairs(rod_state *state, const plan *p)
{
    const rod *r = state->rod;
    double sum = 0;
    pose coarse[2] = {pose_identity(), pose_identity()};
    state->pair_pose[0] = pose_identity();
    if (p->uniform) {
        return chain_uniform(state, p);
    }
    for (int first = 0; first < p->npair; first += LANES) {
        const int count = p->npair - first < LANES ? p->npair - first : LANES;
        lanes half, lever, xi[PAIR_STATIONS][6];
        pair_block b;
        load_pairs(p, state->xi, first, count, &half, xi);
        for (int k = 0; k < LANES; k++) {
            lever[k] = r->length - p->pair_edge[2 * (first + (k < count ? k : count - 1)) + 1];
        }
        step_pairs(r, &half, &lever, (const lanes(*)[6])xi, &b);
        for (int k = 0; k < count; k++) {
            const int pair = first + k;
            sum += b.misfit[k];
            mul_lane(&state->pair_pose[pair], &b.fine, k, &state->pair_pose[pair + 1]);
            mul_lane(&coarse[pair % 2], &b.once, k, &coarse[(pair + 1) % 2]);
        }
    }
    const double tip = vec3_norm(vec3_sub(state->pair_pose[p->npair].p, coarse[p->npair % 2].p));
    const double estimate = (margin * tip + unsigned_share * sum) / (doubled * r->length);
    return r->doubt * estimate + rounding * 2 * p->npair;
}
