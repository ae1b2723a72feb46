#include "fem/body_solid.h"

#include "base/memory.h"

#include <string.h>

// --- layers that are held with all their levels

typedef struct held_layers {
    int first, count;
} held_layers;

static held_layers layers_of(const body *b)
{
    const int first = (b->first + b->order - 1) / b->order, last = (b->last - 1) / b->order;
    return (held_layers){first, last > first ? last - first : 0};
}

// weights of a layer's levels for the solid's levels in it: [plane order + 1][order + 1]
typedef struct level_weights {
    double N[ELEMENT_MAX_ORDER + 1][ELEMENT_MAX_ORDER + 1];
} level_weights;

static status weigh(const body *b, level_weights *w)
{
    status st = OK;
    element line = {0};
    TRY(element_make(SHAPE_LINE, b->plane->order, &line));
    for (int k = 0; k <= b->plane->order; k++) {
        element_basis(&b->line, &line.line_node[k], w->N[k], NULL);
    }

done:
    return st;
}

// out [solid levels][n] from held [levels][n]; the first level of a layer is the last one of the
// layer before
static status resample(const body *b, size_t n, const double *held, double *out)
{
    status st = OK;
    const held_layers layers = layers_of(b);
    level_weights w;
    TRY(weigh(b, &w));
    for (int layer = 0; layer < layers.count; layer++) {
        const size_t from = (size_t)((layers.first + layer) * b->order - b->first);
        for (int k = layer > 0; k <= b->plane->order; k++) {
            double *to = out + (size_t)(layer * b->plane->order + k) * n;
            memset(to, 0, n * sizeof *to);
            for (int l = 0; l <= b->order; l++) {
                for (size_t i = 0; i < n && w.N[k][l] != 0; i++) {
                    to[i] += w.N[k][l] * held[(from + (size_t)l) * n + i];
                }
            }
        }
    }

done:
    return st;
}

status body_solid_values(const body *b, int ncomponent, const double *held, double *solid)
{
    return resample(b, (size_t)ncomponent * (size_t)b->plane->nnode, held, solid);
}

// --- the mesh

static int count_elements(const body *b, int block, held_layers layers)
{
    int n = 0;
    for (int layer = layers.first; layer < layers.first + layers.count; layer++) {
        for (int e = 0; e < b->plane->block[block].nelem; e++) {
            n += body_material(b, block, e, layer) >= 0;
        }
    }
    return n;
}

static void fill_block(const body *b, int block, held_layers layers, mesh_block *to)
{
    const mesh_block *from = &b->plane->block[block];
    const int p = b->plane->order;
    int n = 0;
    for (int layer = 0; layer < layers.count; layer++) {
        for (int e = 0; e < from->nelem; e++) {
            const int material = body_material(b, block, e, layers.first + layer);
            if (material < 0) {
                continue;
            }
            const int *conn = from->conn + (size_t)e * (size_t)from->per_elem;
            int *out = to->conn + (size_t)n * (size_t)to->per_elem;
            for (int k = 0; k <= p; k++) {
                for (int i = 0; i < from->per_elem; i++) {
                    *out++ = conn[i] + b->plane->nnode * (layer * p + k);
                }
            }
            to->material[n++] = material;
        }
    }
}

static status place_nodes(const body *b, double *xyz)
{
    status st = OK;
    const size_t n = (size_t)b->plane->nnode;
    double *held = NULL;
    if (b->node) {
        return resample(b, 3 * n, b->node, xyz);
    }
    TRY(TAKE(held, 3 * n * (size_t)(b->last - b->first)));
    for (int level = b->first; level < b->last; level++) {
        for (size_t i = 0; i < n; i++) {
            body_node(b, (int)i, level, held + 3 * ((size_t)(level - b->first) * n + i));
        }
    }
    st = resample(b, 3 * n, held, xyz);

done:
    free(held);
    return st;
}

status body_solid(const body *b, mesh *out)
{
    status st = OK;
    const held_layers layers = layers_of(b);
    const mesh *plane = b->plane;
    mesh m = {0};
    shape shapes[MESH_MAX_BLOCKS];
    int nelem[MESH_MAX_BLOCKS];
    const double nnode = (double)plane->nnode * ((double)layers.count * plane->order + 1);
    if (layers.count < 1 || nnode > 2e9) {
        TRY(status_fail(layers.count < 1 ? ERR_BUG : ERR_RESOURCE,
                        "segment: %d layers of %d nodes make no mesh to show", layers.count,
                        plane->nnode));
    }
    for (int k = 0; k < plane->nblock; k++) {
        shapes[k] = plane->block[k].shape == SHAPE_QUAD ? SHAPE_HEX : SHAPE_PRISM;
        nelem[k] = count_elements(b, k, layers);
    }
    TRY(mesh_make(plane->order, (int)nnode, plane->nblock, shapes, nelem, &m));
    TRY(place_nodes(b, m.xyz));
    for (int k = 0; k < plane->nblock; k++) {
        fill_block(b, k, layers, &m.block[k]);
    }
    *out = m;
    m = (mesh){0};

done:
    mesh_free(&m);
    return st;
}
