// fem/doubling_plan.c
#include "fem/doubling_plan.h"

#include "fem/plane_symmetry.h"

#include <math.h>

enum { FEWEST_DOUBLINGS = 4, MOST_DOUBLINGS = 28 };

status doubling_refuse(const char *why)
{
    return status_fail(ERR_INPUT,
                       "segment: slabs are not all the same or not free between the "
                       "ends (%s): no doubling",
                       why);
}

// The body's thinnest layer is thick enough for a slab: as many halvings as that takes
int doubling_count(const body *b)
{
    double thin = b->length;
    for (int i = 0; i + b->order < b->nlevel; i += b->order) {
        thin = fmin(thin, b->level[i + b->order] - b->level[i]);
    }
    const int k = (int)ceil(log2(b->length / thin) - 1e-6);
    return k < FEWEST_DOUBLINGS ? FEWEST_DOUBLINGS : k;
}

static bool only_on_tip(const load_column *l)
{
    double inside = 0;
    for (int i = 0; i < 3; i++) {
        inside += fabs(l->body_force[i]) + fabs(l->acceleration[i]);
    }
    return inside == 0 && l->npressure == 0 && !l->holds_move;
}

status doubling_check(const segment_problem *p)
{
    const body_spec *s = &p->body->spec;
    if (s->shape.place || s->matter) {
        return doubling_refuse("its shape or its matter changes along it");
    }
    for (int b = 0; b < s->plane->nblock; b++) {
        for (int e = 0; e < s->plane->block[b].nelem; e++) {
            if (material_varies(s->materials + s->plane->block[b].material[e])) {
                return doubling_refuse("a material is graded along it");
            }
        }
    }
    if (p->nspring || p->nhold) {
        return doubling_refuse("springs or held faces");
    }
    for (int j = 0; j < p->nextra; j++) {
        if (!only_on_tip(p->extra + j)) {
            return doubling_refuse("loads away from the tip");
        }
    }
    if (doubling_count(p->body) > MOST_DOUBLINGS) {
        return doubling_refuse("too thin a layer");
    }
    return p->base == BASE_FREE ? doubling_refuse("a base that nothing holds") : OK;
}

// --- what it will take

// Flops of a doubling and of the slab over n^3: Cholesky, substitution and the product of
// half_joint and join, with two thirds of the unknowns even; (5.12)
static const double JOIN_FLOPS = 1.67, ENDS_FLOPS = 0.34;
// by order along z, 1..4
static const double CONDENSE_FLOPS[5] = {0, 0, 1.67, 4.67, 10};
// OpenBLAS on one core: flops per second of large matrices, and the size at which half of them is
// reached; seconds of one element's stiffness per square of its unknowns. bench/bench_ways.c
// measures them
static const double RATE = 42e9, HALF_RATE = 320, ELEMENT_SECONDS = 2.6e-8;

// unknowns of the largest part of a cut, as far as the nodes tell
static status count_parts(const body *b, int *parts)
{
    status st = OK;
    plane_symmetry on = {0};
    const bool turns = b->spec.turn_rate != 0;
    TRY(plane_symmetry_find(b->plane, turns, &on));
    const bool mirrors = !turns && (on.partner[MIRROR_A] || on.partner[MIRROR_B]);
    const bool both = !turns && on.partner[MIRROR_A] && on.partner[MIRROR_B];
    *parts = both ? 4 : mirrors || on.partner[HALF_TURN] ? 2 : 1;
    if (turns && !on.partner[MIRROR_A] && !on.partner[HALF_TURN]) {
        *parts = 0; // nothing exchanges a slab's ends
    }

done:
    plane_symmetry_free(&on);
    return st;
}

way_cost way_cost_doubling(const segment_problem *p, int nrank)
{
    way_cost cost = {0};
    const body *b = p->body;
    const int k = doubling_count(b);
    int parts = 0;
    (void)nrank; // every rank does all of it
    if (doubling_check(p) != OK || count_parts(b, &parts) != OK || parts == 0) {
        status_clear();
        return cost;
    }
    const double n = 3.0 * b->plane->nnode / parts;
    const double flops = n * n * n * (CONDENSE_FLOPS[b->order] + JOIN_FLOPS * k + ENDS_FLOPS);
    for (int i = 0; i < b->plane->nblock; i++) {
        const double dofs = 3.0 * b->plane->block[i].per_elem * (b->order + 1);
        cost.seconds += ELEMENT_SECONDS * dofs * dofs * b->plane->block[i].nelem;
        cost.bytes += sizeof(double) * dofs * dofs * b->plane->block[i].nelem;
    }
    cost.possible = true;
    cost.seconds += parts * flops / (RATE * n / (n + HALF_RATE));
    cost.bytes += sizeof(double) * n * n * (8 + 1.6 * REPORTED_HALVINGS);
    return cost;
}
