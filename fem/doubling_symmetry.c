// fem/doubling_symmetry.c
#include "fem/doubling_symmetry.h"

#include "base/memory.h"
#include "fem/doubling_plan.h"

#include <math.h>

status doubling_thin_body(const body *b, int doublings, body *out)
{
    const double layer[2] = {0, ldexp(b->length, -doublings)};
    body_spec spec = b->spec;
    spec.nlayer = 1;
    spec.layer = layer;
    spec.hold_first = spec.hold_last = 0;
    return body_make(&spec, out);
}

// Exchanges the slab's ends: mirrored on its middle, or turned by pi about an axis in it, or both
static status find_reversal(const slab *s, const plane_symmetry *on, involution *out)
{
    status st = OK;
    const involution all[4] = {{NULL, {1, 1, -1}},
                               {on->partner[MIRROR_A], {1, -1, -1}},
                               {on->partner[MIRROR_B], {-1, 1, -1}},
                               {on->partner[HALF_TURN], {-1, -1, -1}}};
    for (int k = 0; k < 4; k++) {
        bool has = false;
        if (k == 0 || all[k].image) {
            TRY(slab_has(s, &all[k], true, &has));
        }
        if (has) {
            *out = all[k];
            return OK;
        }
    }
    TRY(doubling_refuse("its two ends are different"));

done:
    return st;
}

static status find_plain(const slab *s, const plane_symmetry *on, int *count, involution *out)
{
    status st = OK;
    const double sign[PLANE_SYMMETRIES][3] = {{1, -1, 1}, {-1, 1, 1}, {-1, -1, 1}};
    for (int k = 0; k < PLANE_SYMMETRIES && *count < 2; k++) {
        const involution g = {on->partner[k], {sign[k][0], sign[k][1], sign[k][2]}};
        bool has = false;
        // with one mirror line a half turn would bring the other
        if (g.image && !(k == HALF_TURN && *count > 0)) {
            TRY(slab_has(s, &g, false, &has));
        }
        if (has) {
            out[(*count)++] = g;
        }
    }

done:
    return st;
}

// roots of the moduli about every node, over the largest
static status node_weights(const body *b, double **out)
{
    status st = OK;
    double most = 0;
    TRY(TAKE(*out, (size_t)b->plane->nnode));
    for (int k = 0; k < b->plane->nblock; k++) {
        const mesh_block *m = &b->plane->block[k];
        for (int i = 0; i < m->nelem * m->per_elem; i++) {
            const double root = sqrt(b->spec.materials[m->material[i / m->per_elem]].E);
            (*out)[m->conn[i]] = fmax((*out)[m->conn[i]], root);
            most = fmax(most, root);
        }
    }
    for (int i = 0; i < b->plane->nnode; i++) {
        (*out)[i] /= most;
    }

done:
    return st;
}

status doubling_slab_make(const body *thin, slab *s, cut *c)
{
    status st = OK;
    plane_symmetry on = {0};
    involution reversal = {0}, plain[2];
    double *weight = NULL;
    int nplain = 0;
    TRY(plane_symmetry_find(thin->plane, thin->spec.turn_rate != 0, &on));
    TRY(slab_make(thin, on.angle, s));
    TRY(find_reversal(s, &on, &reversal));
    TRY(find_plain(s, &on, &nplain, plain));
    TRY(node_weights(thin, &weight));
    TRY(cut_make(thin->plane, &on, &reversal, nplain, plain, weight, c));

done:
    free(weight);
    plane_symmetry_free(&on);
    return st;
}
