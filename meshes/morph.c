#include "meshes/morph.h"

#include "base/memory.h"
#include "meshes/morph_kinds.h"

#include <math.h>

struct mesh_morph {
    int nnode;
    double base;        // [m]
    grid_morph grid;    // one of them
    curve_morph *curve; // NULL: on the grid
};

void mesh_morph_free(mesh_morph *m)
{
    if (m) {
        grid_morph_free(&m->grid);
        curve_morph_free(m->curve);
        free(m);
    }
}

status mesh_morph_make(const section_outline *base, double s, const mesh *plane, mesh_morph **out)
{
    status st = OK;
    mesh_morph *m = NULL;
    bool mapped = false;
    TRY(TAKE(m, 1));
    m->nnode = plane->nnode;
    m->base = s;
    // a free mesh of outlines on a grid has triangles
    if (plane->nblock == 1 && plane->block[0].shape == SHAPE_QUAD) {
        TRY(grid_morph_make(base, plane, &m->grid, &mapped));
    }
    if (!mapped) {
        TRY(curve_morph_make(base, plane, &m->curve));
    }
    *out = m;
    m = NULL;

done:
    mesh_morph_free(m);
    return st;
}

bool mesh_morph_is_mapped(const mesh_morph *m)
{
    return m->curve == NULL;
}

status mesh_morph_nodes(const mesh_morph *m, const section_outline *o, double s, double turn,
                        double *xyz, double *strain)
{
    status st = OK;
    bool same = true;
    *strain = 0;
    TRY(m->curve ? curve_morph_nodes(m->curve, o, turn, xyz, &same, strain)
                 : grid_morph_nodes(&m->grid, m->nnode, o, xyz, &same));
    if (!same) {
        TRY(status_fail(ERR_INPUT,
                        "section: at s = %.6g mm its shapes meet or part otherwise than at s = "
                        "%.6g mm: a 3D body keeps its elements, it has to end before or to begin "
                        "later; or ask for `body: prism`",
                        1e3 * s, 1e3 * m->base));
    }
    if (!isfinite(*strain)) {
        TRY(status_fail(ERR_INPUT,
                        "section: at s = %.6g mm its shapes have moved so far against each other "
                        "since s = %.6g mm that elements between them turn over: take a shorter "
                        "3D body, or ask for `body: prism`",
                        1e3 * s, 1e3 * m->base));
    }

done:
    return st;
}
