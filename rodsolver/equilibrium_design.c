// rodsolver/equilibrium_design.c
// Derivatives of the answer by what the rod itself is, from one design to another: docs/theory.md
// (4.27)
#include "rodsolver/equilibrium_derive.h"

#include <math.h>
#include <string.h>

// the geometric centre's pose in its own frame at the base, at the same part of the length
static pose centre_pose(const equilibrium *e, const place *at)
{
    const plan *p = e->plan;
    const int node = 2 * at->pair;
    const double h = panel_length(p, node);
    const pose left = {e->node_R[node], e->node_p[node]};
    const pose inside = lie_pair_pose(h, &e->xi[PAIR_STATIONS * at->pair], at->t);
    const pose g = pose_mul(e->rod->base, pose_mul(left, inside));
    if (!p->frame) {
        return g;
    }
    centre_frame f;
    const double s = p->pair_edge[2 * at->pair] + h * at->t;
    law_along_centre_frame(e->rod->law, s, p->frame[PAIR_STATIONS * at->pair + 2].phi, &f);
    return pose_mul(g, pose_inverse(centre_frame_pose(&f)));
}

static bool any_friction(const rod *r)
{
    for (int i = 0; i < r->ntendon; i++) {
        if (r->spec[i].friction > 0) {
            return true;
        }
    }
    return false;
}

// the plan of another rod with the panels of this one's; NULL: it has none
static const plan *matching_plan(const rod *own, const plan *p, const rod *other)
{
    const long level = p - own->plans;
    if (other == own) {
        return p;
    }
    if (other->nbreak != own->nbreak) {
        return NULL;
    }
    if (level < other->nplan && other->plans[level].nstation == p->nstation) {
        return &other->plans[level];
    }
    for (int i = 0; i < other->nplan; i++) {
        if (other->plans[i].nstation == p->nstation) {
            return &other->plans[i];
        }
    }
    return NULL;
}

// misfits (body frame, into v and w) and excess lengths of another rod at this rod's strains over
// its rest; the pose at the same part of the length
static status evaluate(rod_state *state, const rod *other, const place *at, vec3 *v, vec3 *w,
                       double *excess, pose *g)
{
    equilibrium *e = state->loaded;
    const rod *own = e->rod;
    const plan *p = e->plan, *q = matching_plan(own, p, other);
    if (!q || other->ntendon != own->ntendon || rod_load_count(other) != rod_load_count(own)) {
        return status_fail(ERR_INPUT, "rod: the designs that are compared have other stations, "
                                      "tendons or loads");
    }
    const bool friction = e->friction;
    e->friction = friction || any_friction(other);
    e->rod = other;
    e->plan = q;
    memcpy(e->old, e->xi, (size_t)p->nstation * sizeof *e->xi);
    for (int i = 0; i < p->nstation; i++) {
        const vec6 strain = vec6_sub(e->xi[i], station_gather(p->rest, p->nstation, i));
        e->xi[i] = vec6_add(station_gather(q->rest, q->nstation, i), strain);
    }
    equilibrium_use_plan(e, q);
    balance_poses(e);
    if (e->friction) {
        balance_friction(e);
    }
    balance_wrenches(e, e->line, e->node);
    const bool good = balance_stations(e, false);
    balance_lengths(e, e->length);
    for (int i = 0; i < own->ntendon; i++) {
        excess[i] = e->pulled[i] ? pull_excess(e, i) : 0;
    }
    for (int i = 0; i < p->nstation; i++) {
        v[i] = mat3_tmul_vec(e->state[i].R, e->state[i].rv);
        w[i] = mat3_tmul_vec(e->state[i].R, e->state[i].rw);
    }
    *g = centre_pose(e, at);
    memcpy(e->xi, e->old, (size_t)p->nstation * sizeof *e->xi);
    e->rod = own;
    e->friction = friction;
    equilibrium_use_plan(e, p);
    return good ? OK : status_fail(ERR_NUMERIC, "rod: a tendon is eaten up in another design");
}

// (g^-1 (plus - minus))^vee / span
static vec6 pose_rate(const pose *plus_pose, const pose *minus_pose, const mat3 *R, double span)
{
    const vec3 dp = vec3_scale(1 / span, vec3_sub(plus_pose->p, minus_pose->p));
    const mat3 a = mat3_mul(mat3_transpose(*R), plus_pose->R);
    const mat3 b = mat3_mul(mat3_transpose(*R), minus_pose->R);
    const vec3 v = mat3_tmul_vec(*R, dp);
    const double c = 1 / (2 * span);
    return (vec6){{v.a[0], v.a[1], v.a[2], c * (a.a[2][1] - a.a[1][2] - b.a[2][1] + b.a[1][2]),
                   c * (a.a[0][2] - a.a[2][0] - b.a[0][2] + b.a[2][0]),
                   c * (a.a[1][0] - a.a[0][1] - b.a[1][0] + b.a[0][1])}};
}

// from one design to another that lies `span` further, at the state's answer: docs/theory.md (4.27)
static status derive_between(rod_state *state, const rod *plus_rod, const rod *minus_rod,
                             double span, double s, vec6 *out)
{
    status st = OK;
    equilibrium *e = state->loaded;
    pose g[2];
    if (!(fabs(span) > 0) || !isfinite(span)) {
        return status_fail(ERR_INPUT, "rod: a step of %g between two designs", span);
    }
    TRY(derive_resume(state));
    const place at = derive_find_place(e, state, fmin(fmax(s, 0), e->rod->length));
    TRY(evaluate(state, plus_rod, &at, e->kept_v, e->kept_w, e->tension_slope, &g[0]));
    TRY(evaluate(state, minus_rod, &at, e->arc_v, e->arc_w, e->tension_old, &g[1]));
    TRY(derive_resume(state));
    for (int i = 0; i < e->plan->nstation; i++) {
        const mat3 *R = &e->state[i].R;
        e->rv[i] = mat3_mul_vec(*R, vec3_scale(1 / span, vec3_sub(e->kept_v[i], e->arc_v[i])));
        e->rw[i] = mat3_mul_vec(*R, vec3_scale(1 / span, vec3_sub(e->kept_w[i], e->arc_w[i])));
    }
    for (int i = 0; i < e->rod->ntendon; i++) {
        e->tension_step[i] = -(e->tension_slope[i] - e->tension_old[i]) / span;
    }
    derive_answer(e);
    TRY(derive_check(e));
    const mat3 R = mat3_mul(mat3_transpose(state->base.R), rod_pose_at(state, at.s).R);
    *out = vec6_add(derive_twist_at(e, &at), pose_rate(&g[0], &g[1], &R, span));

done:
    return st;
}

status rod_derive_design(rod_state *state, const rod *plus, const rod *minus, double step, double s,
                         vec6 *out)
{
    return derive_between(state, plus, minus, 2 * step, s, out);
}

status rod_derive_towards(rod_state *state, const rod *other, double step, double s, vec6 *out)
{
    return derive_between(state, other, state->rod, step, s, out);
}
