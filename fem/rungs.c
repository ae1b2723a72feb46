// fem/rungs.c
#include "fem/rungs.h"

#include "base/memory.h"
#include "fem/corner_strength.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

// Orders rise before elements shrink: what one more layer on both sides of every wall costs is
// worth it only once the elements between are good. Two rungs without layers, two with one on walls
// of a fifth of the radius, then one more layer each.
static const segment_rung rungs[RUNG_COUNT] = {
    {.plane_order = 3, .edge_first = 1, .order = 3, .end_first = 0.1, .between = 0.5},
    {.plane_order = 4, .edge_first = 0.2, .order = 4, .end_first = 0.1, .between = 0.5},
    {.plane_order = 3, .edge_first = 0.02, .order = 4, .end_first = 0.05, .between = 0.5},
    {.plane_order = 4, .edge_first = 0.02, .order = 4, .end_first = 0.02, .between = 0.4},
    {.plane_order = 4, .edge_first = 0.004, .order = 4, .end_first = 0.005, .between = 0.3},
    {.plane_order = 4, .edge_first = 0.0008, .order = 4, .end_first = 0.001, .between = 0.25},
};

segment_rung segment_rung_of(int rung)
{
    return rungs[rung];
}

// --- layers along s

// by what layers grow: with the singular field; then, past what ends do over the radius, doubling
static const double GROWTH = 5, SLOW = 2, REACH = 3;

// a free end is not singular where its wall is not: its layers are so much thicker. Tractions jump
// at interfaces, so that a loaded end needs as thin ones as a held end
static const double FREE_END = 5;

// whatever the length and its changes
enum { MOST_LAYERS = 4096 };

typedef struct march {
    double step, done, between, reach, longest;
} march;

static void advance(march *m)
{
    const double grown = fmin(m->step * GROWTH, fmax(m->step, m->between));
    m->done += m->step;
    m->step = fmin(m->longest, m->done >= m->reach ? fmax(m->step * SLOW, grown) : grown);
}

static march march_from(const segment_rung *r, const rung_body *b, bool at_tip)
{
    const bool is_free = at_tip ? b->tip == TIP_FREE : b->base == BASE_FREE;
    const double soft = is_free ? FREE_END : 1;
    const double longest = b->sections_along > 0 ? b->length / b->sections_along : b->length;
    return (march){.step = fmin(soft * r->end_first * b->radius, longest),
                   .between = r->between * b->radius,
                   .reach = REACH * b->radius,
                   .longest = longest};
}

// the middle in equal parts, none longer than the next layer from either end
static int middle_parts(double gap, const march *up, const march *down)
{
    return (int)fmax(1, ceil(gap / fmin(up->step, down->step) - 1e-9));
}

// layers from both ends while the middle keeps room for as many again; at [MOST_LAYERS + 1] is
// filled from both sides. nlow, nhigh: how many
static void march_inwards(const rung_body *b, march *up, march *down, double *at, int *nlow,
                          int *nhigh)
{
    double *low = at, *high = at + MOST_LAYERS;
    *low = 0;
    *high = b->length;
    while (*high - *low > 2 * (up->step + down->step) && high - low > 4) {
        const bool rise = up->step <= down->step, fall = down->step <= up->step;
        if (rise) {
            low[1] = *low + up->step;
            low++;
            advance(up);
        }
        if (fall) {
            high[-1] = *high - down->step;
            high--;
            advance(down);
        }
    }
    *nlow = (int)(low - at);
    *nhigh = (int)(at + MOST_LAYERS - high);
}

status segment_rung_layers(const segment_rung *r, const rung_body *b, int *nlayer, double **layer)
{
    status st = OK;
    double *at = NULL, *all = NULL;
    march up = march_from(r, b, false), down = march_from(r, b, true);
    int nlow = 0, nhigh = 0;
    TRY(TAKE(at, MOST_LAYERS + 1));
    march_inwards(b, &up, &down, at, &nlow, &nhigh);
    const double low = at[nlow], high = at[MOST_LAYERS - nhigh];
    const int parts = middle_parts(high - low, &up, &down), n = nlow + parts + nhigh;
    TRY(TAKE(all, (size_t)n + 1));
    for (int i = 0; i <= n; i++) {
        all[i] = i <= nlow          ? at[i]
                 : i < nlow + parts ? low + (high - low) * (i - nlow) / parts
                                    : at[MOST_LAYERS - (n - i)];
    }
    *layer = all;
    *nlayer = n;
    all = NULL;

done:
    free(at);
    free(all);
    return st;
}

// --- what is left of the error

// What is left by a rung of the one below where only orders rise, and what one layer more leaves
// beside GROWTH^(-2 lambda): larger than what is measured, docs/theory.md (5.15).
static const double ORDER_LEFT[RUNG_COUNT] = {1, 0.65, 2.0 / 3, 0.6, 0, 0};
static const double LAYER_LEFT = 2;

// a tip's tractions jump at interfaces: its shear and torsion wait for thin elements there
static const double TRACTION_LEFT = 2.0 / 3;

// no rung leaves more of an error in a sequence that converges
static const double SLOWEST = 0.75;

double segment_rung_left(int rung, double nu, int tip)
{
    const double layer = LAYER_LEFT * pow(GROWTH, -2 * corner_strength(nu));
    const double held = ORDER_LEFT[rung] > 0 ? ORDER_LEFT[rung] : layer;
    return tip == TIP_RIGID ? held : fmax(held, TRACTION_LEFT);
}

// e_k = left e_(k-1) and v_k - v_(k-1) = e_(k-1) - e_k
double segment_rung_factor(int rung, double nu, int tip)
{
    const double left = segment_rung_left(rung, nu, tip);
    return left / (1 - left);
}

// the middle's law has the section's own corners, and orders that fall from rung to rung
// what the order of the plane elements falls by takes from that
static const double FALL = 1.5;

double segment_rung_law_factor(int rung)
{
    const bool falls = rung > 0 && rungs[rung].plane_order < rungs[rung - 1].plane_order;
    return (falls ? FALL : 1) * segment_rung_slowest();
}

double segment_rung_slowest(void)
{
    return SLOWEST / (1 - SLOWEST);
}

double segment_rung_error(int rung, double nu, int tip, int n, const double *value)
{
    const double last = fabs(value[n - 1] - value[n - 2]);
    double factor = segment_rung_factor(rung, nu, tip);
    if (n > 2) {
        // slower than expected: as slow from now on, but for what three values cannot tell
        const double before = fabs(value[n - 2] - value[n - 3]);
        const double seen = before > 0 ? fmin(last / before, SLOWEST) : SLOWEST;
        factor = fmax(factor, seen / (1 - seen));
    }
    return factor * last;
}
