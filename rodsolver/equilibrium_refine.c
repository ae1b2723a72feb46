// rodsolver/equilibrium_refine.c
// An answer carried from plan to plan, and how far it is off: docs/theory.md (4.25)
#include "rodsolver/equilibrium.h"

#include <math.h>
#include <string.h>

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
void equilibrium_transfer(equilibrium *e, const plan *to)
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

// --- the error of an answer

// Newton's own error is a part of the tolerance of the tip, and never below rounding
static const double newton_share = 0.05, least_newton = 2e-14, coarse_newton = 1e-6;

double refine_newton_tolerance(const equilibrium *e)
{
    return fmax(newton_share * e->rod->options.tolerance, least_newton);
}

vec3 refine_tip(equilibrium *e)
{
    balance_poses(e);
    return e->node_p[2 * e->plan->npair];
}

// The tips of a plan and of one with about half its panels differ by about the coarse one's error:
// at order 6 by 63 times the fine one's. That order is believed where both follow the rod: where
// they agree, and where no panel is long against the rod's own lengths, 1/|w| and sqrt(EI / |N|)
static const double margin = 3, rounding = 2e-16;
static const double near = 1e-4, far = 1e-2, short_panel = 0.75, long_panel = 2;
static const double most_ratio = 2;
// a panel that both plans have must be this part of the longest one: to the sixth power that is a
// twentieth of the error
static const double unseen = 0.6;
enum { ORDER = 6, DOUBTED_ORDER = 4, BENT_ORDER = 2, LEAST_ORDER = 1 };

static bool has_pair(const plan *p, const double *edge)
{
    const int k = plan_pair_at(p, (edge[0] + edge[1]) / 2);
    return p->pair_edge[2 * k] == edge[0] && p->pair_edge[2 * k + 1] == edge[1];
}

// The longest panels in the rod's own lengths, of all and of those that a coarser plan has too:
// their errors cancel in the difference of the two. After balance_poses and balance_wrenches
typedef struct panels {
    double longest, shared;
} panels;

static panels measure_panels(const equilibrium *e, const plan *coarse)
{
    const plan *p = e->plan;
    panels out = {0, 0};
    for (int k = 0; k < p->npair; k++) {
        double longest = 0;
        for (int i = PAIR_STATIONS * k; i < PAIR_STATIONS * (k + 1); i++) {
            const double *x = e->xi[i].a;
            const double w2 = x[3] * x[3] + x[4] * x[4] + x[5] * x[5];
            const double EI = fmin(p->K[i].a[3][3], p->K[i].a[4][4]);
            const double rate2 = fmax(w2, vec3_norm(e->state[i].N) / EI);
            longest = fmax(longest, panel_length(p, 2 * k) * sqrt(rate2));
        }
        out.longest = fmax(out.longest, longest);
        out.shared =
            has_pair(coarse, &p->pair_edge[2 * k]) ? fmax(out.shared, longest) : out.shared;
    }
    return out;
}

static double estimate(const equilibrium *e, const panels *of, vec3 coarse, const plan *coarse_plan,
                       vec3 fine)
{
    const double apart = vec3_norm(vec3_sub(fine, coarse)) / e->rod->length;
    const double nfine = e->plan->npair, ratio = fmin(nfine / coarse_plan->npair, most_ratio);
    const double longest = of->longest;
    if (of->shared > unseen * longest) {
        return HUGE_VAL;
    }
    int order = apart < near && longest < short_panel ? ORDER : DOUBTED_ORDER;
    order = apart < far && longest < long_panel ? order : LEAST_ORDER;
    const int rubbing = e->bent_back ? BENT_ORDER : DOUBTED_ORDER;
    order = e->friction && order > rubbing ? rubbing : order;
    return margin * apart / (pow(ratio, order) - 1) + rounding * 2 * nfine;
}

int refine_level_of(const rod *r, const plan *p)
{
    return (int)(p - r->plans);
}

// the coarsest plan beyond `level` with at least this many times its panels
int refine_level_beyond(const rod *r, int level, double times)
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
    const vec3 tip = refine_tip(e);
    const panels of =
        measure_panels(e, coarse); // before the coarse plan's wrenches take their place
    double moved;
    memcpy(e->old, e->xi, (size_t)fine->nstation * sizeof *e->xi);
    memcpy(e->tension_old, e->tension, (size_t)e->rod->ntendon * sizeof *e->tension);
    const int negative = e->negative, determinant = e->determinant;
    equilibrium_transfer(e, coarse);
    const bool found =
        newton_correct(e, fmax(coarse_newton, refine_newton_tolerance(e)), 8, &moved);
    const vec3 other = refine_tip(e);
    memcpy(e->xi, e->old, (size_t)fine->nstation * sizeof *e->xi);
    memcpy(e->tension, e->tension_old, (size_t)e->rod->ntendon * sizeof *e->tension);
    equilibrium_use_plan(e, fine);
    e->negative = negative;
    e->determinant = determinant;
    return found ? estimate(e, &of, other, coarse, tip) : HUGE_VAL;
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

// from a coarse answer at factor 1 to one within the tolerance, on plans with at most twice as many
// panels each, the last two of which tell the error
static int refine(equilibrium *e, double *error)
{
    const rod *r = e->rod;
    vec3 coarse = refine_tip(e);
    for (int level = refine_level_of(r, e->plan); level < r->nplan - 1;) {
        const int next = refine_level_beyond(r, level, fmin(more_panels(e, *error), most_ratio));
        const int negative = e->negative;
        double moved;
        equilibrium_transfer(e, &r->plans[next]);
        if (!newton_correct(e, refine_newton_tolerance(e), 12, &moved) || moved > 0.5 ||
            (e->conservative && e->negative != negative)) {
            return ROUGH_FAILED;
        }
        const vec3 fine = refine_tip(e);
        const panels of = measure_panels(e, &r->plans[level]);
        *error = estimate(e, &of, coarse, &r->plans[level], fine);
        if (*error <= r->options.tolerance) {
            return REFINED;
        }
        coarse = fine;
        level = next;
    }
    return ROUGH_LEFT;
}

// from the way's end on a coarse plan to an answer within the tolerance
int refine_finish(equilibrium *e, double *error)
{
    const rod *r = e->rod;
    const plan *coarse = coarser_plan(e);
    *error = coarse ? compare_coarser(e, coarse) : HUGE_VAL;
    if (*error <= r->options.tolerance || r->options.npanel > 0) {
        return REFINED;
    }
    return refine_level_of(r, e->plan) == r->nplan - 1 ? ROUGH_LEFT : refine(e, error);
}
