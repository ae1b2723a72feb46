// rodsolver/equilibrium.c
// A request from its start to the answer: the way on a coarse plan, then the answer on finer ones
// until the estimate meets the tolerance. docs/theory.md (4.25)
#include "rodsolver/equilibrium.h"

#include <math.h>
#include <string.h>

// --- what is asked for

static void demand_of(const rod_state *state, const rod_request *q, demand *d)
{
    const rod *r = state->rod;
    for (int i = 0; i < r->ntendon; i++) {
        d->pull[i] = q->pull ? q->pull[i] : NAN;
        d->tension[i] = state->tension[i];
    }
    for (int i = 0; i < rod_load_count(r); i++) {
        d->load[i] = q->load ? q->load[i] : 1;
    }
    d->tip_space = q->tip_space;
    d->tip_body = q->tip_body;
    d->to_base = mat3_transpose(mat3_mul(state->base.R, r->base.R));
}

static bool is_zero(const double *a, int n)
{
    for (int i = 0; i < n; i++) {
        if (a[i] != 0) {
            return false;
        }
    }
    return true;
}

static void classify_load(int frame, const double *force, const double *moment, bool line,
                          equilibrium *e)
{
    const bool turns = frame == LOAD_BODY;
    e->lines = e->lines || line;
    e->followers = e->followers || (turns && !is_zero(force, 3));
    // a moment that keeps its direction has no potential either
    e->conservative = e->conservative && !turns && is_zero(moment, 3);
}

static bool field_is_zero(const field *f)
{
    return !field_varies(f) && f->value == 0;
}

static void classify_demand(equilibrium *e, const demand *d)
{
    const rod *r = e->rod;
    static const double some[3] = {1, 1, 1}, none[3] = {0};
    for (int i = 0; i < r->npoint_load; i++) {
        const point_load *l = &r->point_loads[i];
        if (d->load[i] != 0) {
            classify_load(l->frame, l->force, l->moment, false, e);
        }
    }
    for (int i = 0; i < r->nline_load + r->has_gravity; i++) {
        const line_load *l = i < r->nline_load ? &r->line_loads[i] : NULL;
        const bool moment = l && !(field_is_zero(&l->moment[0]) && field_is_zero(&l->moment[1]) &&
                                   field_is_zero(&l->moment[2]));
        if (d->load[r->npoint_load + i] != 0) {
            classify_load(l ? l->frame : LOAD_SPACE, some, moment ? some : none, true, e);
        }
    }
    classify_load(LOAD_SPACE, d->tip_space.a, d->tip_space.a + 3, false, e);
    if (!is_zero(d->tip_body.a, 6)) {
        classify_load(LOAD_BODY, d->tip_body.a, d->tip_body.a + 3, false, e);
    }
}

static void classify(equilibrium *e)
{
    e->conservative = true;
    e->lines = e->followers = e->friction = false;
    classify_demand(e, &e->from);
    classify_demand(e, &e->to);
    for (int i = 0; i < e->rod->ntendon; i++) {
        const bool pulls = e->from.tension[i] > 0 || e->to.tension[i] > 0 || !isnan(e->to.pull[i]);
        e->friction = e->friction || (pulls && e->rod->spec[i].friction > 0);
    }
    e->conservative = e->conservative && !e->friction;
}

// --- plans

static vec6 rest_at(const plan *p, int station)
{
    return station_gather(p->rest, p->nstation, station);
}

static void rest_lengths(equilibrium *e)
{
    const plan *p = e->plan;
    for (int i = 0; i < p->nstation; i++) {
        e->scratch[i] = e->xi[i];
        e->xi[i] = rest_at(p, i);
    }
    balance_lengths(e, e->rest_length);
    for (int i = 0; i < p->nstation; i++) {
        e->xi[i] = e->scratch[i];
    }
}

// everything that belongs to a plan, but the strains
void equilibrium_use_plan(equilibrium *e, const plan *p)
{
    e->plan = p;
    if (pull_any(e)) {
        rest_lengths(e);
    }
    for (int i = 0; e->friction && i < e->rod->ntendon; i++) {
        for (int k = 0; k < e->room; k++) {
            e->decay[(size_t)i * (size_t)e->room + (size_t)k] = 1;
        }
    }
    loads_prepare(e);
    loads_at_factor(e);
}

// the strains at the stations of another plan, by the polynomials over pairs of panels
static void transfer(equilibrium *e, const plan *to)
{
    const plan *p = e->plan;
    int pair = 0;
    for (int i = 0; i < to->nstation; i++) {
        while (pair + 1 < p->npair && to->s[i] > p->pair_edge[2 * pair + 1]) {
            pair++;
        }
        const double *edge = &p->pair_edge[2 * pair];
        double weight[PAIR_STATIONS];
        lie_pair_weights(2 * (to->s[i] - edge[0]) / (edge[1] - edge[0]), weight);
        vec6 strain = rest_at(to, i);
        for (int j = 0; j < PAIR_STATIONS; j++) {
            const int k = PAIR_STATIONS * pair + j;
            const vec6 change = vec6_sub(e->xi[k], rest_at(p, k));
            strain = vec6_add(strain, vec6_scale(weight[j], change));
        }
        e->scratch[i] = strain;
    }
    memcpy(e->xi, e->scratch, (size_t)to->nstation * sizeof *e->xi);
    equilibrium_use_plan(e, to);
}

void equilibrium_start_at_rest(equilibrium *e, const plan *p)
{
    for (int i = 0; i < p->nstation; i++) {
        e->xi[i] = rest_at(p, i);
    }
    memset(e->tension, 0, (size_t)e->rod->ntendon * sizeof *e->tension);
    for (int i = 0; i < e->rod->ntendon; i++) {
        e->slack[i] = e->pulled[i];
    }
    e->factor = 0;
    equilibrium_use_plan(e, p);
}

// --- the answer

// Newton's own error is a part of the tolerance of the tip, and never below rounding
static const double newton_share = 0.05, least_newton = 2e-14, coarse_newton = 1e-6;

static double newton_tolerance(const equilibrium *e)
{
    return fmax(newton_share * e->rod->options.tolerance, least_newton);
}

static vec3 tip_of(equilibrium *e)
{
    balance_poses(e);
    return e->node_p[2 * e->plan->npair];
}

// The tips of a plan and of one with about half its panels differ by about the coarse one's error:
// at order 6 by 63 times the fine one's. That order is believed where both follow the rod: where
// they agree, and where no panel is long against the rod's own lengths, 1/|w| and sqrt(EI / |N|)
static const double margin = 3, rounding = 2e-16;
static const double near = 3e-4, far = 1e-2, short_panel = 1, long_panel = 2;
static const double most_ratio = 2;
enum { ORDER = 6, DOUBTED_ORDER = 4, LEAST_ORDER = 1 };

// the longest panel in the rod's own lengths; after balance_poses and balance_wrenches
static double longest_panel(const equilibrium *e)
{
    const plan *p = e->plan;
    double longest = 0;
    for (int i = 0; i < p->nstation; i++) {
        const double *x = e->xi[i].a;
        const double w2 = x[3] * x[3] + x[4] * x[4] + x[5] * x[5];
        const double EI = fmin(p->K[i].a[3][3], p->K[i].a[4][4]);
        const double rate2 = fmax(w2, vec3_norm(e->state[i].N) / EI);
        longest = fmax(longest, panel_length(p, i / GAUSS_STATIONS) * sqrt(rate2));
    }
    return longest;
}

static double estimate(const equilibrium *e, vec3 coarse, double ncoarse, vec3 fine, double nfine)
{
    const double apart = vec3_norm(vec3_sub(fine, coarse)) / e->rod->length;
    const double longest = longest_panel(e), ratio = fmin(nfine / ncoarse, most_ratio);
    int order = apart < near && longest < short_panel ? ORDER : DOUBTED_ORDER;
    order = apart < far && longest < long_panel ? order : LEAST_ORDER;
    order = e->friction && order == ORDER ? DOUBTED_ORDER : order;
    return margin * apart / (pow(ratio, order) - 1) + rounding * 2 * nfine;
}

static int level_of(const rod *r, const plan *p)
{
    return (int)(p - r->plans);
}

// the coarsest plan beyond `level` with at least this many times its panels
static int level_beyond(const rod *r, int level, double times)
{
    int k = level + 1;
    while (k < r->nplan - 1 && r->plans[k].npair < times * r->plans[level].npair) {
        k++;
    }
    return k;
}

// how many times the panels for the tolerance
static double more_panels(const equilibrium *e, double error)
{
    const double wanted = e->rod->options.tolerance / 2;
    return isfinite(error) ? fmax(1.2, pow(error / wanted, 1.0 / ORDER)) : 2;
}

// the error of a fine answer from a coarser plan that starts with it
static double compare_coarser(equilibrium *e, const plan *coarse)
{
    const plan *fine = e->plan;
    const vec3 tip = tip_of(e);
    double moved;
    memcpy(e->old, e->xi, (size_t)fine->nstation * sizeof *e->xi);
    memcpy(e->tension_old, e->tension, (size_t)e->rod->ntendon * sizeof *e->tension);
    const int negative = e->negative, determinant = e->determinant;
    transfer(e, coarse);
    const bool found = newton_correct(e, fmax(coarse_newton, newton_tolerance(e)), 8, &moved);
    const vec3 other = tip_of(e);
    memcpy(e->xi, e->old, (size_t)fine->nstation * sizeof *e->xi);
    memcpy(e->tension, e->tension_old, (size_t)e->rod->ntendon * sizeof *e->tension);
    equilibrium_use_plan(e, fine);
    e->negative = negative;
    e->determinant = determinant;
    return found ? estimate(e, other, coarse->npair, tip, fine->npair) : HUGE_VAL;
}

static const plan *coarser_plan(const equilibrium *e)
{
    const rod *r = e->rod;
    const plan *best = r->half.npair > 0 ? &r->half : NULL;
    for (int k = 0; k < r->nplan; k++) {
        if (3 * r->plans[k].npair <= 2 * e->plan->npair) {
            best = &r->plans[k];
        }
    }
    return best;
}

enum { REFINED, ROUGH_FAILED, ROUGH_LEFT };

// from a coarse answer at factor 1 to one within the tolerance, on plans with at most twice as many
// panels each, the last two of which tell the error
static int refine(equilibrium *e, double *error)
{
    const rod *r = e->rod;
    vec3 coarse = tip_of(e);
    for (int level = level_of(r, e->plan); level < r->nplan - 1;) {
        const int next = level_beyond(r, level, fmin(more_panels(e, *error), most_ratio));
        const int negative = e->negative;
        double moved;
        transfer(e, &r->plans[next]);
        if (!newton_correct(e, newton_tolerance(e), 12, &moved) || moved > 0.5 ||
            (e->conservative && e->negative != negative)) {
            return ROUGH_FAILED;
        }
        const vec3 fine = tip_of(e);
        *error = estimate(e, coarse, r->plans[level].npair, fine, r->plans[next].npair);
        if (*error <= r->options.tolerance) {
            return REFINED;
        }
        coarse = fine;
        level = next;
    }
    return ROUGH_LEFT;
}

// --- failures

static status fail_way(const equilibrium *e, const path *way, int outcome)
{
    if (outcome == PATH_LIMIT) {
        return status_fail(ERR_NUMERIC,
                           "rod: a limit point at %.6g of the load: beyond it the rod snaps to "
                           "another shape",
                           way->factor);
    }
    for (int j = 0; j < e->rod->ntendon; j++) {
        const plan_tendon *t = &e->plan->tendon[j];
        for (int i = 0; i < t->nstation; i++) {
            if (vec3_norm(tendon_direction(&t->place[i], &e->xi[i])) < 0.02) {
                return status_fail(ERR_NUMERIC,
                                   "rod: tendon '%s' has eaten its own length at s = %.6g m under "
                                   "%.6g N, at %.6g of the load",
                                   e->rod->spec[j].name ? e->rod->spec[j].name : "?", e->plan->s[i],
                                   e->tension[j], way->factor);
            }
        }
    }
    return status_fail(ERR_NUMERIC, "rod: no equilibrium was found beyond %.6g of the load",
                       way->factor);
}

static status fail_tolerance(const equilibrium *e, double error)
{
    return status_fail(ERR_NUMERIC,
                       "rod: the estimated error of the tip, %.2g of the length, stays above the "
                       "tolerance %.2g with %d panels",
                       error, e->rod->options.tolerance, 2 * e->plan->npair);
}

// from the way's end on a coarse plan to an answer within the tolerance
static int finish(equilibrium *e, double *error)
{
    const rod *r = e->rod;
    const plan *coarse = coarser_plan(e);
    *error = coarse ? compare_coarser(e, coarse) : HUGE_VAL;
    if (*error <= r->options.tolerance || r->options.npanel > 0) {
        return REFINED;
    }
    return level_of(r, e->plan) == r->nplan - 1 ? ROUGH_LEFT : refine(e, error);
}

// --- between the state and the equilibrium

static void load_answer(equilibrium *e, const rod_state *state)
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

static void store_answer(equilibrium *e, rod_state *state)
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

status equilibrium_resume(rod_state *state)
{
    equilibrium *e = state->loaded;
    if (!state->solved) {
        return status_fail(ERR_BUG, "rod: derivatives are asked for before a solution");
    }
    if (!state->by_load) {
        equilibrium_remember(state);
    }
    demand_copy(e->rod, &e->to, &e->from);
    memcpy(e->from.tension, state->tension, (size_t)e->rod->ntendon * sizeof *e->tension);
    memcpy(e->tension, state->tension, (size_t)e->rod->ntendon * sizeof *e->tension);
    classify(e);
    // also those whose factor is 0: by it may be derived
    e->lines = e->rod->nline_load + e->rod->has_gravity > 0;
    load_answer(e, state);
    if (!newton_linearize(e)) {
        return status_fail(ERR_NUMERIC, "rod: the answer is a critical point");
    }
    return OK;
}

static vec6 largest_strain(const equilibrium *e)
{
    const plan *p = e->plan;
    vec6 worst = {0};
    for (int i = 0; i < p->nstation; i++) {
        vec6 x = vec6_sub(e->xi[i], rest_at(p, i));
        if (p->frame) {
            x = mat6_mul_vec(se3_adjoint(centre_frame_pose(&p->frame[i])), x);
        }
        for (int c = 0; c < 6; c++) {
            worst.a[c] = fmax(worst.a[c], fabs(x.a[c]));
        }
    }
    return worst;
}

static void tell(equilibrium *e, const rod_state *state, double error, rod_solution *out)
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

// --- one request

enum { LEAST_PAIRS = 2, CRITICAL_PAIRS = 8, ATTEMPTS = 9 };

// Two plans' critical points may differ by this many times the tolerance: the finer plan's are 63
// times nearer
static const double settled = 30, least_settled = 1e-9;

static int level_with(const rod *r, int level, int pairs)
{
    while (level < r->nplan - 1 && r->plans[level].npair < pairs) {
        level++;
    }
    return level;
}

static bool critical_settled(const rod *r, const path *way, const path *before)
{
    const double apart = settled * fmax(r->options.tolerance, least_settled);
    bool same = way->ncritical == before->ncritical;
    for (int i = 0; same && i < way->ncritical && i < ROD_MAX_CRITICAL; i++) {
        const rod_critical *a = &way->critical[i], *b = &before->critical[i];
        same = a->kind == b->kind && fabs(a->fraction - b->fraction) <= apart;
    }
    return same;
}

static bool start(equilibrium *e, const rod_state *state, bool warm, int level)
{
    const plan *p = &e->rod->plans[level];
    double moved;
    if (!warm) {
        equilibrium_start_at_rest(e, p);
        return true;
    }
    load_answer(e, state);
    if (p != e->plan) {
        transfer(e, p);
        return newton_correct(e, newton_tolerance(e), CORRECTIONS, &moved);
    }
    return true;
}

// The way from the start: on a coarse plan (the last answer's, where it starts there), and again on
// finer ones where that was too coarse for its own answer or for the critical points on it
static status solve_way(equilibrium *e, const rod_state *state, bool warm, path *way, double *error,
                        int *outcome)
{
    const rod *r = e->rod;
    int level = warm ? level_of(r, state->solved) : level_with(r, 0, LEAST_PAIRS);
    path before = {.ncritical = -1};
    vec3 tip = {{0, 0, 0}};
    for (int k = 0; k < ATTEMPTS; k++) {
        *way = (path){.past = way->past};
        *outcome = PATH_LOST;
        if (start(e, state, warm, level)) {
            *outcome = path_follow(e, way, newton_tolerance(e));
        }
        const int refined = *outcome == PATH_ARRIVED ? finish(e, error) : ROUGH_FAILED;
        if (*outcome == PATH_LIMIT) {
            const vec3 now = tip_of(e);
            *error = vec3_norm(vec3_sub(now, tip)) / r->length;
            tip = now;
        }
        const bool last = level == r->nplan - 1,
                   told = refined == REFINED || *outcome == PATH_LIMIT;
        if (told && (way->ncritical == 0 || last || critical_settled(r, way, &before))) {
            return *outcome == PATH_LIMIT ? fail_way(e, way, *outcome) : OK;
        }
        if (last || refined == ROUGH_LEFT) {
            break;
        }
        before = *way;
        level = level_beyond(r, level, 2);
        level = told ? level_with(r, level, CRITICAL_PAIRS) : level;
    }
    if (*outcome == PATH_ARRIVED) {
        *outcome = PATH_LOST;
        return fail_tolerance(e, *error);
    }
    return fail_way(e, way, *outcome);
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

status equilibrium_solve(rod_state *state, const rod_request *request, rod_solution *out)
{
    status st = OK;
    equilibrium *e = state->loaded;
    path way = {.past = request->past};
    double error = 0;
    int outcome = PATH_LOST;
    const bool warm = state->solved && !request->cold;
    if (warm) {
        demand_copy(e->rod, &e->to, &e->from);
        // those that were found for pulled lengths, too
        memcpy(e->from.tension, e->tension, (size_t)e->rod->ntendon * sizeof *e->tension);
    }
    demand_of(state, request, &e->to);
    if (!warm) {
        demand_nothing(e->rod, &e->to, &e->from);
    }
    e->iterations = 0;
    for (int i = 0; i < e->rod->ntendon; i++) {
        e->pulled[i] = !isnan(e->to.pull[i]);
    }
    classify(e);
    st = solve_way(e, state, warm, &way, &error, &outcome);
    state->solved = NULL;
    out->fraction = way.factor;
    out->ncritical = way.ncritical;
    memcpy(out->critical, way.critical, sizeof out->critical);
    if (st == OK || outcome == PATH_LIMIT) {
        balance_poses(e);
        if (e->friction) {
            balance_friction(e);
        }
        store_answer(e, state);
        tell(e, state, error, out);
        equilibrium_keep_wrenches(e);
        // at a limit point the second variation is singular: the rod does not stay there
        out->stable = outcome == PATH_LIMIT && out->stable > 0 ? 0 : out->stable;
    }
    if (st == OK && request->stability) {
        equilibrium_judge(state, out);
    }
    return st;
}
