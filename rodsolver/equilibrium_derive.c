// rodsolver/equilibrium_derive.c
// Derivatives of the answer by one more right-hand side each: docs/theory.md (4.27)
#include "rodsolver/equilibrium_derive.h"
#include "rodsolver/collocation.h"

#include <math.h>
#include <string.h>

// --- where a derivative starts

// What the collocation of the linearised equations leaves of a derivative over panels that turn by
// theta each: this times theta^6, most of it between the nodes. A pose needs far fewer panels where
// the strains hardly vary, docs/theory.md (4.6)
static const double left_by_turn = 1.5e-5;

static double longest_panel(const plan *p)
{
    double longest = 0;
    for (int k = 0; k < p->npair; k++) {
        longest = fmax(longest, panel_length(p, 2 * k));
    }
    return longest;
}

// the coarsest plan from the one at hand on that derives to the rod's tolerance
static const plan *plan_for_rates(const equilibrium *e)
{
    const rod *r = e->rod;
    const plan *p = e->plan;
    double rate = 0;
    for (int i = 0; i < p->nstation; i++) {
        rate = fmax(rate, vec3_norm(vec6_angular(e->xi[i])));
    }
    const double turn = pow(r->options.tolerance / left_by_turn, 1.0 / 6);
    while (p < &r->plans[r->nplan - 1] && rate * longest_panel(p) > turn) {
        p++;
    }
    return p;
}

status derive_resume(rod_state *state)
{
    status st = OK;
    equilibrium *e = state->loaded;
    TRY(equilibrium_recall(state));
    e->lost = false;
    // under load the plan at hand has met the tolerance by the collocation itself
    if (!state->by_load && e->rod->options.npanel == 0) {
        const plan *p = plan_for_rates(e);
        if (p != e->plan) {
            equilibrium_transfer(e, p);
        }
    }
    TRY(equilibrium_linearize(e));

done:
    return st;
}

// --- how a pose moves by a linear answer

// how the stations' p' change: phi x p' + nu
static void slope_changes(const equilibrium *e, int k, vec3 change[GAUSS_STATIONS])
{
    const double h = panel_length(e->plan, k);
    const int first = GAUSS_STATIONS * k;
    for (int j = 0; j < GAUSS_STATIONS; j++) {
        vec3 phi = e->phi[k];
        for (int l = 0; l < GAUSS_STATIONS; l++) {
            phi = vec3_add_scaled(phi, h * gauss_inner[j][l], e->omega[first + l]);
        }
        change[j] = vec3_add(vec3_cross(phi, e->state[first + j].slope), e->nu[first + j]);
    }
}

// the Gauss points between the last node before the place and the place itself
static void find_inside(const equilibrium *e, place *at)
{
    const int pair = at->pair, before = (int)at->t;
    const double h = panel_length(e->plan, 2 * pair), rest = at->t - before;
    const vec6 *xi = &e->xi[PAIR_STATIONS * pair];
    const pose left = {e->node_R[2 * pair], e->node_p[2 * pair]};
    at->node = 2 * pair + before;
    at->inside = h * rest;
    if (!(rest > 0)) {
        return;
    }
    const vec3 end = pose_mul(left, lie_pair_pose(h, xi, at->t)).p;
    at->arm = vec3_sub(end, e->node_p[at->node]);
    for (int i = 0; i < GAUSS_STATIONS; i++) {
        const double t = before + rest * gauss_point[i];
        const pose g = pose_mul(left, lie_pair_pose(h, xi, t));
        at->point[i].R = g.R;
        at->point[i].arm = vec3_sub(end, g.p);
        lie_pair_weights(t, at->point[i].weight);
    }
}

place derive_find_place(const equilibrium *e, const rod_state *state, double s)
{
    place at = {.s = s, .to_gc = mat6_identity()};
    const plan *p = e->plan;
    at.pair = plan_pair_at(p, s);
    const double *edge = &p->pair_edge[2 * at.pair];
    at.t = fmin(fmax(2 * (s - edge[0]) / (edge[1] - edge[0]), 0), 2);
    find_inside(e, &at);
    const pose world = rod_pose_at(state, s);
    const pose base = pose_mul(state->base, e->rod->base);
    at.R = mat3_mul(mat3_transpose(base.R), world.R);
    if (p->frame) {
        centre_frame f;
        law_along_centre_frame(e->rod->law, s, p->frame[PAIR_STATIONS * at.pair + 2].phi, &f);
        at.to_gc = se3_adjoint(centre_frame_pose(&f));
        at.R = mat3_mul(at.R, centre_frame_pose(&f).R);
    }
    return at;
}

// over whole panels the collocation's sums, of order 6 at their ends; from there on the motion that
// a node's rotation and the strains make, which vary little in the body's axes
vec6 derive_twist_at(const equilibrium *e, const place *at)
{
    vec3 moved = {{0, 0, 0}}, turned = e->phi[at->node], change[GAUSS_STATIONS];
    for (int k = 0; k < at->node; k++) {
        slope_changes(e, k, change);
        for (int j = 0; j < GAUSS_STATIONS; j++) {
            moved = vec3_add_scaled(moved, panel_length(e->plan, k) * gauss_weight[j], change[j]);
        }
    }
    if (at->inside > 0) {
        moved = vec3_add(moved, vec3_cross(turned, at->arm));
    }
    for (int i = 0; at->inside > 0 && i < GAUSS_STATIONS; i++) {
        const inside_point *q = &at->point[i];
        vec6 strain = {{0}};
        for (int j = 0; j < PAIR_STATIONS; j++) {
            strain =
                vec6_add(strain, vec6_scale(q->weight[j], e->step[PAIR_STATIONS * at->pair + j]));
        }
        const double share = at->inside * gauss_weight[i];
        const vec3 nu = mat3_mul_vec(q->R, vec6_linear(strain));
        const vec3 omega = mat3_mul_vec(q->R, vec6_angular(strain));
        moved = vec3_add_scaled(moved, share, vec3_add(nu, vec3_cross(omega, q->arm)));
        turned = vec3_add_scaled(turned, share, omega);
    }
    const vec3 v = mat3_tmul_vec(at->R, moved), w = mat3_tmul_vec(at->R, turned);
    return mat6_mul_vec(at->to_gc, (vec6){{v.a[0], v.a[1], v.a[2], w.a[0], w.a[1], w.a[2]}});
}

// --- right-hand sides

static void no_misfits(equilibrium *e)
{
    memset(e->rv, 0, (size_t)e->plan->nstation * sizeof *e->rv);
    memset(e->rw, 0, (size_t)e->plan->nstation * sizeof *e->rw);
    memset(e->tension_step, 0, (size_t)e->rod->ntendon * sizeof *e->tension_step);
}

// part of a derivative that tensions following by friction may leave out
static const double followed = 1e-12;

void derive_answer(equilibrium *e)
{
    e->lost = !friction_solve(e, followed, e->tension_step, e->step) || e->lost;
}

status derive_check(const equilibrium *e)
{
    return e->lost ? status_fail(ERR_NUMERIC, "rod: no derivative with friction was found") : OK;
}

// by the load of a demand, at this shape
static void answer_load(equilibrium *e, const demand *d)
{
    loads_of(e, d);
    no_misfits(e);
    newton_sum_misfits(e);
    derive_answer(e);
}

static void derive_tensions(equilibrium *e, const place *at, const rod_derivatives *out)
{
    const int n = e->rod->ntendon;
    for (int i = 0; (out->tension || out->length_by_tension) && i < n; i++) {
        vec6 twist = {{0}};
        if (!e->pulled[i]) {
            no_misfits(e);
            pull_misfit(e, i, 1);
            derive_answer(e);
            twist = derive_twist_at(e, at);
        }
        if (out->tension) {
            out->tension[i] = twist;
        }
        for (int j = 0; out->length_by_tension && j < n; j++) {
            out->length_by_tension[j * n + i] =
                e->pulled[i] ? 0 : pull_length_change(e, j, e->step);
        }
    }
    for (int i = 0; out->pull && i < n; i++) {
        out->pull[i] = (vec6){{0}};
        if (e->pulled[i] && !e->slack[i]) {
            no_misfits(e);
            e->tension_step[i] = -1;
            derive_answer(e);
            out->pull[i] = derive_twist_at(e, at);
        }
    }
}

static void derive_loads(equilibrium *e, const place *at, const rod_derivatives *out)
{
    demand *d = &e->from; // no longer needed
    for (int i = 0; out->load && i < rod_load_count(e->rod); i++) {
        demand_nothing(e->rod, &e->to, d);
        d->load[i] = 1;
        answer_load(e, d);
        out->load[i] = derive_twist_at(e, at);
    }
    for (int c = 0; c < 6; c++) {
        for (int body = 0; body < 2; body++) {
            mat6 *columns = body ? out->tip_body : out->tip_space;
            if (columns) {
                demand_nothing(e->rod, &e->to, d);
                (body ? &d->tip_body : &d->tip_space)->a[c] = 1;
                answer_load(e, d);
                const vec6 twist = derive_twist_at(e, at);
                for (int i = 0; i < 6; i++) {
                    columns->a[i][c] = twist.a[i];
                }
            }
        }
    }
}

// loads that keep their directions turn in the base frame when the base turns
static void derive_base(equilibrium *e, const rod_state *state, double s, const place *at,
                        mat6 *out)
{
    const rod *r = e->rod;
    demand *d = &e->from;
    *out = se3_adjoint(pose_mul(pose_inverse(rod_pose_at(state, s)), state->base));
    for (int c = 0; c < 3; c++) {
        vec3 axis = {{0, 0, 0}};
        axis.a[c] = -1;
        demand_copy(r, &e->to, d);
        d->tip_body = (vec6){{0}};
        for (int i = 0; i < r->npoint_load + r->nline_load; i++) {
            const int frame = i < r->npoint_load ? r->point_loads[i].frame
                                                 : r->line_loads[i - r->npoint_load].frame;
            d->load[i] = frame == LOAD_SPACE ? d->load[i] : 0;
        }
        d->to_base = mat3_mul(mat3_hat(mat3_tmul_vec(r->base.R, axis)), e->to.to_base);
        answer_load(e, d);
        const vec6 twist = derive_twist_at(e, at);
        for (int i = 0; i < 6; i++) {
            out->a[i][3 + c] += twist.a[i];
        }
    }
}

status rod_derive(rod_state *state, double s, const rod_derivatives *out)
{
    status st = OK;
    equilibrium *e = state->loaded;
    TRY(derive_resume(state));
    const double clipped = fmin(fmax(s, 0), e->rod->length);
    const place at = derive_find_place(e, state, clipped);
    derive_tensions(e, &at, out);
    derive_loads(e, &at, out);
    if (out->base) {
        derive_base(e, state, clipped, &at, out->base);
    }
    st = derive_check(e);

done:
    return st;
}
