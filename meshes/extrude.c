// meshes/extrude.c
#include "meshes/mesher.h"

#include "base/memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

// Layer k's size grows by the same factor from both ends to the middle, where it is `grading` times
// the ends'.
static double layer_size(const extrude_options *o, int k)
{
    const int from_end = k < o->layers - 1 - k ? k : o->layers - 1 - k;
    const int middle = (o->layers - 1) / 2;
    return middle > 0 ? pow(o->grading, (double)from_end / middle) : 1;
}

static status make_levels(const extrude_options *o, int order, double *z)
{
    status st = OK;
    element line = {0};
    double total = 0, below = 0;

    TRY(element_make(SHAPE_LINE, order, &line));
    for (int k = 0; k < o->layers; k++) {
        total += layer_size(o, k);
    }
    for (int k = 0; k < o->layers; k++) {
        const double from = o->length * (below / total);
        below += layer_size(o, k);
        const double to = k == o->layers - 1 ? o->length : o->length * (below / total);
        for (int i = 0; i <= order; i++) {
            z[k * order + i] = from + (to - from) * (line.line_node[i] + 1) / 2;
        }
    }
    z[o->layers * order] = o->length;

done:
    return st;
}

static status check_options(const mesh *plane, const extrude_options *o)
{
    if (plane->dim != 2) {
        return status_fail(ERR_BUG, "extrusion: the mesh is not plane");
    }
    if (o->order != 0 && o->order != plane->order) {
        return status_fail(ERR_INPUT, "extrusion: order %d along z differs from the section's %d",
                           o->order, plane->order);
    }
    if (!(isfinite(o->length) && o->length > 0) || o->layers < 2 ||
        !(isfinite(o->grading) && o->grading >= 1)) {
        return status_fail(ERR_INPUT,
                           "extrusion: length %g m, %d layers and grading %g; needed are a length "
                           "above 0, two layers or more, and a grading of 1 or more",
                           o->length, o->layers, o->grading);
    }
    const double levels = (double)o->layers * plane->order + 1;
    if (levels * plane->nnode > 1e8) {
        return status_fail(ERR_RESOURCE, "extrusion: %d layers of %d nodes are too many", o->layers,
                           plane->nnode);
    }
    return OK;
}

static void extrude_block(const mesh *plane, const mesh_block *from, int layers, mesh_block *to)
{
    const int nlocal = plane->order + 1;
    for (int k = 0; k < layers; k++) {
        for (int e = 0; e < from->nelem; e++) {
            const size_t at = (size_t)k * (size_t)from->nelem + (size_t)e;
            const int *conn = from->conn + (size_t)e * (size_t)from->per_elem;
            int *out = to->conn + at * (size_t)to->per_elem;
            for (int level = 0; level < nlocal; level++) {
                for (int i = 0; i < from->per_elem; i++) {
                    *out++ = conn[i] + plane->nnode * (k * plane->order + level);
                }
            }
            to->material[at] = from->material[e];
        }
    }
}

status mesh_extrude(const mesh *plane, const extrude_options *options, mesh *out, double **levels)
{
    status st = OK;
    mesh m = {0};
    double *z = NULL;
    shape shapes[MESH_MAX_BLOCKS];
    int nelem[MESH_MAX_BLOCKS];

    TRY(check_options(plane, options));
    const int nlevel = options->layers * plane->order + 1;
    TRY(TAKE(z, (size_t)nlevel));
    TRY(make_levels(options, plane->order, z));
    for (int b = 0; b < plane->nblock; b++) {
        shapes[b] = plane->block[b].shape == SHAPE_QUAD ? SHAPE_HEX : SHAPE_PRISM;
        nelem[b] = plane->block[b].nelem * options->layers;
    }
    TRY(mesh_make(plane->order, plane->nnode * nlevel, plane->nblock, shapes, nelem, &m));
    for (int k = 0; k < nlevel; k++) {
        double *xyz = m.xyz + 3 * (size_t)k * (size_t)plane->nnode;
        memcpy(xyz, plane->xyz, 3 * (size_t)plane->nnode * sizeof *xyz);
        for (int i = 0; i < plane->nnode; i++) {
            xyz[3 * (size_t)i + 2] = z[k];
        }
    }
    for (int b = 0; b < plane->nblock; b++) {
        extrude_block(plane, &plane->block[b], options->layers, &m.block[b]);
    }
    *out = m;
    m = (mesh){0};
    if (levels) {
        *levels = z;
        z = NULL;
    }

done:
    free(z);
    mesh_free(&m);
    return st;
}
