// rodsolver/equilibrium_between.c
// Wrenches between the stations. Those at the stages are of a lower order than the poses, so that
// they are found again by statics: from the end of the pair of panels. docs/theory.md (4.30)
#include "rodsolver/equilibrium.h"

void equilibrium_keep_wrenches(equilibrium *e)
{
    for (int k = 0; k < e->plan->npair; k++) {
        e->answer_N[k] = e->node_N[2 * k + 2];
        e->answer_M[k] = e->node_M[2 * k + 2];
    }
}

// the solve's frame seen from the geometric one
static pose frame_at(const rod_state *state, int pair, double s)
{
    const plan *p = state->solved;
    if (!p->frame) {
        return pose_identity();
    }
    centre_frame f;
    law_along_centre_frame(state->rod->law, s, p->frame[PAIR_STATIONS * pair + 2].phi, &f);
    return centre_frame_pose(&f);
}

// the solve's frame at s in the base frame
static pose pose_in_base(const rod_state *state, int pair, double s)
{
    const pose base = pose_mul(state->base, state->rod->base);
    const pose here = pose_mul(rod_pose_at(state, s), frame_at(state, pair, s));
    return pose_mul(pose_inverse(base), here);
}

static load_sum line_at(const equilibrium *e, int pair, double t)
{
    enum { NUMBERS = sizeof(load_sum) / sizeof(double) };
    double weight[PAIR_STATIONS];
    load_sum sum = {0};
    lie_pair_weights(t, weight);
    for (int j = 0; j < PAIR_STATIONS; j++) {
        const double *one = (const double *)&e->line[PAIR_STATIONS * pair + j];
        for (int i = 0; i < NUMBERS; i++) {
            ((double *)&sum)[i] += weight[j] * one[i];
        }
    }
    return sum;
}

// adds the line loads between s and the pair's end, about p
static void add_lines(const rod_state *state, int pair, double s, vec3 p, vec3 *N, vec3 *M)
{
    const equilibrium *e = state->loaded;
    const double *edge = &e->plan->pair_edge[2 * pair];
    const double half = (edge[1] - s) / 2;
    for (int i = 0; half > 0 && i < 2 * GAUSS_STATIONS; i++) {
        const double x = s + half * (gauss_point[i % GAUSS_STATIONS] + i / GAUSS_STATIONS);
        const double weight = half * gauss_weight[i % GAUSS_STATIONS];
        const pose there = pose_in_base(state, pair, x);
        const load_sum l = line_at(e, pair, 2 * (x - edge[0]) / (edge[1] - edge[0]));
        vec3 f = {{0, 0, 0}}, m = {{0, 0, 0}};
        balance_add_load(&l, &there.R, &f, &m);
        m = vec3_add(m, vec3_cross(vec3_sub(there.p, p), f));
        *N = vec3_add(*N, vec3_scale(weight, f));
        *M = vec3_add(*M, vec3_scale(weight, m));
    }
}

vec6 equilibrium_wrench_at(const rod_state *state, double s)
{
    const equilibrium *e = state->loaded;
    const plan *p = state->solved;
    const int pair = plan_pair_at(p, s);
    const pose here = pose_in_base(state, pair, s);
    const vec3 lever = vec3_sub(state->pair_pose[pair + 1].p, here.p);
    vec3 N = e->answer_N[pair];
    vec3 M = vec3_add(e->answer_M[pair], vec3_cross(lever, N));
    if (e->lines) {
        add_lines(state, pair, s, here.p, &N, &M);
    }
    const vec3 n = mat3_tmul_vec(here.R, N), m = mat3_tmul_vec(here.R, M);
    const mat6 turn = se3_adjoint(pose_inverse(frame_at(state, pair, s)));
    return mat6_mul_vec(mat6_transpose(turn),
                        (vec6){{n.a[0], n.a[1], n.a[2], m.a[0], m.a[1], m.a[2]}});
}
