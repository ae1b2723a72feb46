// fem/direct_cost.c
// What the direct way will take, from counts alone.
#include "fem/way.h"

#include "base/memory.h"

#include <math.h>

// Factors of nested dissection of a grid of a >= b >= c nodes, three unknowns each: separators are
// b c nodes first, and what is left to either side is as wide. Fitted on MUMPS' own counts for
// tubes of 3e4 to 2.3e5 unknowns of order 2 to 4, to 15 %. docs/theory.md (5.13)
static const double FLOPS = 29 * 27, ENTRIES = 5 * 9;

// One core of an AMD EPYC of 2024, as bench_ways measures it: flops per second in fronts of 3 b c
// unknowns and the size of front at which half of them is reached; seconds per entry of the factors
// and column solved; per entry of elements' matrices, when a prism shares its plane integrals among
// layers and when not.
static const double RATE = 40e9, HALF_RATE = 1550, SOLVE_SECONDS = 6e-10, PRISM_SECONDS = 4.5e-9,
                    BRICK_SECONDS = 1.2e-8;
// the first solution and a refinement; elements are asked to assemble and for each residual
enum { SOLVES = 2, PASSES = 2 };

// of factors, of the matrix twice; of fields per unknown and column
static const double ENTRY_BYTES = 9, MATRIX_BYTES = 9.5, FIELDS = 8;

// starting the libraries
static const double START_SECONDS = 0.05;

typedef struct grid {
    double a, b, c; // nodes, a >= b >= c
} grid;

static void order_two(double *more, double *less)
{
    const double larger = fmax(*more, *less);
    *less = fmin(*more, *less);
    *more = larger;
}

// sides of the plane mesh that only one element has
static status border_sides(const mesh *m, double *count)
{
    status st = OK;
    int *valence = NULL;
    double corners = 0, elements = 0;
    TRY(TAKE(valence, (size_t)m->nnode));
    // Euler: V - E + F = 1 - holes, E = (sides of elements + border) / 2
    double sides = 0;
    for (int k = 0; k < m->nblock; k++) {
        const mesh_block *b = &m->block[k];
        const int p = m->order, n = b->per_elem;
        const int quad[4] = {0, p, n - 1 - p, n - 1}, triangle[3] = {0, p, n - 1};
        const int *corner = b->shape == SHAPE_QUAD ? quad : triangle;
        const int ncorner = b->shape == SHAPE_QUAD ? 4 : 3;
        sides += (double)ncorner * b->nelem;
        elements += b->nelem;
        for (int e = 0; e < b->nelem; e++) {
            for (int i = 0; i < ncorner; i++) {
                int *seen = &valence[b->conn[(size_t)e * (size_t)n + (size_t)corner[i]]];
                corners += *seen == 0;
                *seen = 1;
            }
        }
    }
    // with one hole or none: border = 2 (V + F) - sides, less 2 without a hole
    *count = fmax(1, 2 * (corners + elements) - sides);

done:
    free(valence);
    return st;
}

// the section as long as its border and as wide as that leaves
static status grid_of(const body *body, grid *out)
{
    status st = OK;
    double border = 1;
    TRY(border_sides(body->plane, &border));
    const double along = border * body->plane->order / 2, n = body->plane->nnode;
    *out = (grid){body->nlevel, along, n / along};
    order_two(&out->b, &out->c);
    order_two(&out->a, &out->b);
    order_two(&out->b, &out->c);

done:
    return st;
}

// entries of all elements' matrices
static double element_entries(const body *b)
{
    double sum = 0;
    for (int k = 0; k < b->plane->nblock; k++) {
        const double dofs = 3.0 * b->plane->block[k].per_elem * (b->order + 1);
        sum += dofs * dofs * b->plane->block[k].nelem;
    }
    return sum * b->nlayer;
}

way_cost way_cost_direct(const segment_problem *p, int nrank)
{
    way_cost cost = {0};
    grid g;
    const body *b = p->body;
    const double columns = problem_columns(p), unknowns = 3.0 * (double)body_node_count(b);
    if (grid_of(b, &g) != OK) {
        status_clear();
        return cost;
    }
    const double front = 3 * g.b * g.c, elements = element_entries(b);
    const double flops = FLOPS * g.a * g.b * g.b * g.c * g.c * g.c;
    const double entries = ENTRIES * g.a * g.b * g.c * g.c * log2(2 + g.b);
    const double each = b->prism ? PRISM_SECONDS : BRICK_SECONDS;
    cost.possible = true;
    cost.seconds =
        START_SECONDS + (flops / (RATE * front / (front + HALF_RATE)) +
                         SOLVES * columns * SOLVE_SECONDS * entries + PASSES * each * elements) /
                            nrank;
    cost.bytes = (ENTRY_BYTES * entries + MATRIX_BYTES * elements / 2 +
                  FIELDS * columns * sizeof(double) * unknowns) /
                 nrank;
    return cost;
}
