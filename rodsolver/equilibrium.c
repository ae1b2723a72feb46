// rodsolver/equilibrium.c
// A request from its start to the answer: the way on a coarse plan, then the answer on finer ones
// until the estimate meets the tolerance. docs/theory.md (4.25)
#include "rodsolver/equilibrium.h"

#include <math.h>
#include <string.h>

static status fail_way(const equilibrium *e, const path *way, int outcome)
{
    if (outcome == PATH_LIMIT) {
        return status_fail(ERR_NUMERIC,
                           "rod: a limit point at %.6g of the load: beyond it the rod snaps to "
                           "another shape",
                           way->factor);
    }
    int tendon, station;
    if (balance_finds_eaten(e, &tendon, &station)) {
        const char *name = e->rod->spec[tendon].name;
        return status_fail(ERR_NUMERIC,
                           "rod: tendon '%s' has eaten its own length at s = %.6g mm under %.6g N, "
                           "at %.6g of the load",
                           name ? name : "?", 1e3 * e->plan->s[station], e->tension[tendon],
                           e->factor);
    }
    if (balance_finds_pressed(e, &station)) {
        return status_fail(ERR_NUMERIC,
                           "rod: pressed to nothing at s = %.6g mm, at %.6g of the load",
                           1e3 * e->plan->s[station], e->factor);
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
    equilibrium_load_answer(e, state);
    if (p != e->plan) {
        equilibrium_transfer(e, p);
        return newton_correct(e, refine_newton_tolerance(e), CORRECTIONS, &moved);
    }
    return true;
}

// The way from the start: on a coarse plan (the last answer's, where it starts there), and again on
// finer ones where that was too coarse for its own answer or for the critical points on it
static status solve_way(equilibrium *e, const rod_state *state, bool warm, path *way, double *error,
                        int *outcome)
{
    const rod *r = e->rod;
    int level = warm ? refine_level_of(r, state->solved) : level_with(r, 0, LEAST_PAIRS);
    path before = {.ncritical = -1};
    vec3 tip = {{0, 0, 0}};
    for (int k = 0; k < ATTEMPTS; k++) {
        *way = (path){.past = way->past};
        *outcome = PATH_LOST;
        if (start(e, state, warm, level)) {
            *outcome = path_follow(e, way, refine_newton_tolerance(e));
        }
        const int refined = *outcome == PATH_ARRIVED ? refine_finish(e, error) : ROUGH_FAILED;
        if (*outcome == PATH_LIMIT) {
            const vec3 now = refine_tip(e);
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
        level = refine_level_beyond(r, level, 2);
        level = told ? level_with(r, level, CRITICAL_PAIRS) : level;
    }
    if (*outcome == PATH_ARRIVED) {
        *outcome = PATH_LOST;
        return fail_tolerance(e, *error);
    }
    return fail_way(e, way, *outcome);
}

// The way from follower loads or friction to an end without them: the end has a potential again
static void see_end_alone(equilibrium *e)
{
    demand_copy(e->rod, &e->to, &e->from);
    memcpy(e->from.tension, e->tension, (size_t)e->rod->ntendon * sizeof *e->tension);
    demand_classify(e);
    e->conservative = e->conservative && newton_linearize(e);
}

status equilibrium_solve(rod_state *state, const rod_request *request, rod_solution *out)
{
    status st = OK;
    equilibrium *e = state->loaded;
    path way = {.past = request->past};
    double error = 0;
    int outcome = PATH_LOST;
    const bool warm = state->solved && !state->at_limit && !request->cold;
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
    demand_classify(e);
    st = solve_way(e, state, warm, &way, &error, &outcome);
    state->solved = NULL;
    out->limited = outcome == PATH_LIMIT;
    out->fraction = way.factor;
    out->ncritical = way.ncritical;
    memcpy(out->critical, way.critical, sizeof out->critical);
    if (st == OK && warm && !e->conservative) {
        see_end_alone(e);
    }
    if (st == OK || outcome == PATH_LIMIT) {
        balance_poses(e);
        if (e->friction) {
            balance_friction(e);
        }
        equilibrium_store_answer(e, state);
        state->at_limit = outcome == PATH_LIMIT;
        equilibrium_tell(e, state, error, out);
        equilibrium_keep_wrenches(e);
        // at a limit point the second variation is singular: the rod does not stay there
        out->stable = outcome == PATH_LIMIT && out->stable > 0 ? 0 : out->stable;
    }
    if (st == OK && request->stability) {
        equilibrium_judge(state, out);
    }
    return st;
}
