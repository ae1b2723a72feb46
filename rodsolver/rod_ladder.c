// rodsolver/rod_ladder.c
// Which plans a rod needs for its tolerance: tried on probing loads when it is made.
#include "base/memory.h"
#include "rodsolver/rod_plan.h"

#include <math.h>

status plan_add(rod *r, int npanel)
{
    status st = OK;
    TRY(plan_make(r, npanel, &r->plans[r->nplan]));
    r->nplan++;

done:
    return st;
}

// two panels, then steps of 3/2 and 4/3
static const int panel_count[ROD_MAX_PLANS] = {2,  4,   6,   8,   12,  16,  24,  32,   48,   64,
                                               96, 128, 192, 256, 384, 512, 768, 1024, 1536, 2048};

const double rod_probe_share[ROD_PROBES] = {0.2, 0.4, 0.6, 0.8};

// finer than the strongest probe needs: room for what lies between it and the critical tension
enum { PLANS_IN_RESERVE = 2 };

// two plans may differ by this part of the length through rounding alone
static const double rounding = 1e-14;

// tendon i alone, or all together for i = ntendon, at a share of what each can pull alone
static void set_probe(rod_state *state, int i, double share)
{
    const rod *r = state->rod;
    const plan *p = &r->plans[r->nplan - 1];
    state->nactive = 0;
    for (int j = 0; j < r->ntendon; j++) {
        state->tension[j] = 0;
        if (i == j || i == r->ntendon) {
            state->tension[j] = share * p->tendon[j].critical / (i == j ? 1 : r->ntendon);
            state->active[state->nactive++] = j;
        }
    }
}

// the plan, and room for its answers beside the load that the state stands for
static status plan_at(rod *r, int level, rod_state *state)
{
    status st = OK;
    rod_state larger = {0};
    if (level >= r->nplan) {
        TRY(plan_add(r, panel_count[level]));
        TRY(state_take(r, &larger));
        larger.nactive = state->nactive;
        for (int i = 0; i < state->nactive; i++) {
            larger.active[i] = state->active[i];
        }
        for (int i = 0; state->tension && i < r->ntendon; i++) {
            larger.tension[i] = state->tension[i];
        }
        state_give_back(state);
        *state = larger;
    }

done:
    return st;
}

// A step of order 6 makes the estimate of what two plans differ by 63 times smaller; without that
// order the difference itself tells, and no doubt need be greater
static const double most_doubt = 63;

// The estimate trusts the order of the method. Where a path or a law has a kink inside a panel it
// would be too small: then the next plan's tip tells, and all estimates of this rod are raised
static bool confirmed(rod *r, const rod_solution *coarse, const rod_solution *fine)
{
    const double moved = vec3_norm(vec3_sub(coarse->tip.p, fine->tip.p)) / r->length;
    if (moved <= coarse->relative_error + rounding) {
        return true;
    }
    r->doubt = fmin(r->doubt * 2 * moved / coarse->relative_error, most_doubt);
    return false;
}

static bool solves(rod_state *state, const plan *p, rod_solution *out)
{
    if (solve_on_plan(state, p, out) != OK) {
        // such a load is refused when it is asked for
        status_clear();
        return false;
    }
    return true;
}

// raises *level until the estimate of this probe meets the tolerance and the next plan confirms it
static status probe(rod *r, rod_state *state, int load, double share, int *level)
{
    status st = OK;
    // once: the critical tension that a plan sees depends on its stations
    set_probe(state, load, share);
    for (; *level < ROD_MAX_PLANS - 1; ++*level) {
        rod_solution coarse = {0}, fine = {0};
        TRY(plan_at(r, *level, state));
        if (!solves(state, &r->plans[*level], &coarse)) {
            break;
        }
        if (coarse.relative_error > r->options.tolerance) {
            continue;
        }
        TRY(plan_at(r, *level + 1, state));
        if (!solves(state, &r->plans[*level + 1], &fine) || confirmed(r, &coarse, &fine)) {
            break;
        }
    }

done:
    return st;
}

// A rod bent by a load through a turn or two meets 1e-6 of its length with this many panels
static const double panels_for_loads = 48, tolerance_of_them = 1e-6;

static int level_for_loads(const rod *r)
{
    const double n = panels_for_loads * pow(tolerance_of_them / r->options.tolerance, 1.0 / 6);
    int k = 0;
    while (k < ROD_MAX_PLANS - 1 && panel_count[k] < n) {
        k++;
    }
    return k;
}

status plans_choose(rod *r)
{
    status st = OK;
    rod_state state = {0};
    int level = 0;
    TRY(plan_at(r, 0, &state));
    for (int k = 0; k < ROD_PROBES; k++) {
        const int loads = r->ntendon > 1 ? r->ntendon + 1 : r->ntendon;
        for (int load = 0; load < loads; load++) {
            TRY(probe(r, &state, load, rod_probe_share[k], &level));
        }
        r->first_plan[k] = level;
    }
    level += PLANS_IN_RESERVE;
    level = level > level_for_loads(r) ? level : level_for_loads(r);
    for (int k = r->nplan; k < ROD_MAX_PLANS && k <= level; k++) {
        TRY(plan_at(r, k, &state));
    }

done:
    state_give_back(&state);
    return st;
}
