// meshes/mesher.c
#include "meshes/mesher.h"

#include "meshes/edge_pieces.h"
#include "meshes/edges.h"
#include "meshes/free.h"
#include "meshes/grid.h"
#include "meshes/mapped.h"
#include "meshes/shape_frame.h"

#include <math.h>
#include <stdlib.h>

static status check_options(const mesh_options *options)
{
    const mark at = options->at;
    if (options->order < 1 || options->order > ELEMENT_MAX_ORDER) {
        return status_fail_at(ERR_INPUT, at.line, at.column, "mesh: order %d is not 1 to %d",
                              options->order, ELEMENT_MAX_ORDER);
    }
    if (options->edge_layers < 0 || options->edge_layers > EDGE_MOST_LAYERS ||
        !(isfinite(options->edge_first) && options->edge_first >= 0)) {
        return status_fail_at(ERR_INPUT, at.line, at.column,
                              "mesh: %d edge layers from %g of the radius: 0 to %d are possible",
                              options->edge_layers, options->edge_first, EDGE_MOST_LAYERS);
    }
    if (!(isfinite(options->size) && options->size >= 0)) {
        return status_fail_at(ERR_INPUT, at.line, at.column, "mesh: a size of %g m is no length",
                              options->size);
    }
    return OK;
}

status section_mesh_make(const section_outline *o, const mesh_options *options, mesh *out)
{
    status st = OK;
    grid g = {0};
    mesh m = {0};
    int *owner = NULL;
    bool found = false;

    TRY(check_options(options));
    if (options->kind != MESH_FREE) {
        TRY(grid_make(o, &g, &found));
    }
    if (options->kind == MESH_MAPPED && !found) {
        TRY(status_fail_at(
            ERR_INPUT, options->at.line, options->at.column,
            "mesh: the shapes do not lie on one polar or Cartesian grid (without its "
            "centre, and with no cell thinner than 1e-5 of the section): kind mapped "
            "is not possible here, choose auto or free"));
    }
    if (found) {
        TRY(mapped_mesh_make(o, &g, options, &m, &owner));
    } else {
        TRY(free_mesh_make(o, options, &m, &owner));
    }
    TRY(mesh_check_connected(&m, owner, o));
    TRY(mesh_check(&m));
    TRY(shape_frames_to_mesh(o, owner, &m));
    *out = m;
    m = (mesh){0};

done:
    free(owner);
    mesh_free(&m);
    grid_free(&g);
    return st;
}

bool section_mesh_is_mapped(const section_outline *o)
{
    grid g = {0};
    bool found = false;
    const status st = grid_make(o, &g, &found);
    grid_free(&g);
    return st == OK && found;
}
