// fem/iterative_cost.c
// What the iterative way will take, from counts alone.
#include "fem/iterative.h"

// Measured by bench_segment_size on one core of an AMD EPYC of 2024: products without a matrix, all
// else per unknown, column and iteration, and the plane's factors and element tables per unknown
static const double SECONDS_PER_FLOP = 8e-11, SECONDS_PER_VALUE = 4e-8, SECONDS_PER_UNKNOWN = 2e-6;
// fields of the conjugate gradients and of what is exchanged; factors of planes
static const double FIELDS = 12, FACTOR_BYTES = 400;
enum { PRISM_ITERATIONS = 24, MAPPED_ITERATIONS = 45, PRODUCTS = 2, COARSE_MODES = 66 };
// what points cost more where each has a place of its own
static const double MAPPED = 1.6;

// The same with a matrix and algebraic multigrid: half a dozen products a step, grids made once
static const double SECONDS_PER_ENTRY = 8e-9, BYTES_PER_ENTRY = 40;
enum { GRID_ITERATIONS = 20, SETUP_STEPS = 25 };
// the mixed form near nu = 1/2 takes hundreds
static const double MIXED_STEPS = 20;

// of one product with one column, as apply.h does it
static double product_flops(const body *b)
{
    double flops = 0;
    const double p = b->order, nl = b->line_table.npoint;
    for (int k = 0; k < b->plane->nblock; k++) {
        const double n2 = b->plane->block[k].per_elem, np = b->plane_table[k].npoint;
        const double plane = 18 * np * n2 * p, line = 18 * np * (p + 1) * nl, law = 81;
        flops += b->plane->block[k].nelem * (2 * plane + 2 * line + law * nl * np);
    }
    return flops * b->nlayer;
}

// entries in a row of the assembled matrix: nodes that share an element along one direction, cubed
static double row_entries(const body *b)
{
    const double p = b->plane->order, l = b->order;
    const double across = (p * p + 2 * p) / p, along = (l * l + 2 * l) / l;
    return 3 * across * across * along;
}

static way_cost with_matrix(const segment_problem *p, double share)
{
    const body *b = p->body;
    const double unknowns = 3.0 * (double)body_node_count(b), entries = unknowns * row_entries(b);
    const double plain = GRID_ITERATIONS * b->order * problem_columns(p);
    const double steps = plain * (b->spec.mixed ? MIXED_STEPS : 1);
    return (way_cost){.possible = true,
                      .seconds = share * SECONDS_PER_ENTRY * entries * (SETUP_STEPS + steps),
                      .bytes = share * BYTES_PER_ENTRY * entries};
}

way_cost way_cost_iterative(const segment_problem *p, int nrank)
{
    const body *b = p->body;
    const double columns = problem_columns(p), unknowns = 3.0 * (double)body_node_count(b);
    // whole layers are shared out
    const double share = 1.0 / (nrank < b->nlayer ? nrank : b->nlayer);
    if (!iterative_is_plain(p)) {
        return with_matrix(p, share);
    }
    const double product = SECONDS_PER_FLOP * product_flops(b) * (b->prism ? 1 : MAPPED);
    const double each = PRODUCTS * product + SECONDS_PER_VALUE * unknowns;
    const double steps = columns * (b->prism ? PRISM_ITERATIONS : MAPPED_ITERATIONS);
    // the coarse space of a body that is no prism takes products of its own
    const double coarse = b->prism ? 0 : COARSE_MODES * (b->order + 1) * product;
    return (way_cost){.possible = true,
                      .seconds = share * (SECONDS_PER_UNKNOWN * unknowns + coarse + steps * each),
                      .bytes =
                          share * unknowns * (sizeof(double) * FIELDS * columns + FACTOR_BYTES)};
}
