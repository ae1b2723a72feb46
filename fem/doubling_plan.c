// fem/doubling_plan.c
#include "fem/doubling_plan.h"

#include "base/memory.h"
#include "fem/doubling_symmetry.h"

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
// reached; seconds of one element's stiffness per square of its unknowns. bench/bench_doubling.c
// measures them
static const double RATE = 42e9, HALF_RATE = 320, ELEMENT_SECONDS = 2.6e-8;

// Every reversal of an isotropic prism is known beforehand; of other slabs the elements must say
static bool is_plain(const body *b)
{
    bool plain = b->spec.turn_rate == 0;
    for (int i = 0; i < b->plane->nblock; i++) {
        for (int e = 0; e < b->plane->block[i].nelem; e++) {
            const material *m = b->spec.materials + b->plane->block[i].material[e];
            plain = plain && m->kind == MATERIAL_ISOTROPIC;
        }
    }
    return plain;
}

// Whether the elements about every node are of the same materials as those about its image
static bool keeps_materials(const mesh *plane, const int *image, const double *about)
{
    for (int i = 0; image && i < plane->nnode; i++) {
        if (about[i] != about[image[i]]) {
            return false;
        }
    }
    return image != NULL;
}

static status count_plain_parts(const mesh *plane, int *parts)
{
    status st = OK;
    plane_symmetry on = {0};
    double *about = NULL;
    TRY(plane_symmetry_find(plane, false, &on));
    TRY(TAKE(about, (size_t)plane->nnode));
    for (int b = 0; b < plane->nblock; b++) {
        const mesh_block *k = &plane->block[b];
        for (int i = 0; i < k->nelem * k->per_elem; i++) {
            about[k->conn[i]] += 1 + 37.0 * k->material[i / k->per_elem];
        }
    }
    const bool a = keeps_materials(plane, on.partner[MIRROR_A], about);
    const bool b = keeps_materials(plane, on.partner[MIRROR_B], about);
    *parts = a && b ? 4 : a || b || keeps_materials(plane, on.partner[HALF_TURN], about) ? 2 : 1;

done:
    free(about);
    plane_symmetry_free(&on);
    return st;
}

// how many parts a cut has: of a plain prism by nodes and materials alone; ERR_INPUT where nothing
// exchanges the slab's ends
static status count_parts(const body *b, int doublings, int *parts)
{
    status st = OK;
    body thin = {0};
    slab s = {0};
    cut c = {0};
    if (is_plain(b)) {
        TRY(count_plain_parts(b->plane, parts));
    } else {
        TRY(doubling_thin_body(b, doublings, &thin));
        TRY(doubling_slab_make(&thin, &s, &c));
        *parts = c.npart;
    }

done:
    body_free(&thin);
    slab_free(&s);
    cut_free(&c);
    return st;
}

way_cost way_cost_doubling(const segment_problem *p, int nrank)
{
    way_cost cost = {0};
    const body *b = p->body;
    int parts = 0;
    (void)nrank; // every rank does all of it
    if (doubling_check(p) != OK || count_parts(b, doubling_count(b), &parts) != OK) {
        status_clear();
        return cost;
    }
    const int k = doubling_count(b);
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
