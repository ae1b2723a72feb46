// meshes/morph_kinds.h
// The two kinds of morph.h.
#pragma once

#include "meshes/grid.h"
#include "meshes/morph.h"

// --- on a grid

// Where a node lies: in a cell of the grid, at a part of it between 0 and 1.
typedef struct grid_place {
    int cell[2];
    double part[2];
} grid_place;

typedef struct grid_morph {
    grid g;            // at the base
    grid_place *place; // [nnode]
} grid_morph;

// *found false where the outlines lie on no grid.
status grid_morph_make(const section_outline *base, const mesh *plane, grid_morph *out,
                       bool *found);
void grid_morph_free(grid_morph *m);
// *same false where the grid at s has other cells.
status grid_morph_nodes(const grid_morph *m, int nnode, const section_outline *o, double *xyz,
                        bool *same);

// --- on curves

typedef struct curve_morph curve_morph;

status curve_morph_make(const section_outline *base, const mesh *plane, curve_morph **out);
void curve_morph_free(curve_morph *m);
// *same false where a curve or a corner of the base is missing. *strain as in morph.h, INFINITY
// where a triangle of the nodes is turned over.
status curve_morph_nodes(const curve_morph *m, const section_outline *o, double turn, double *xyz,
                         bool *same, double *strain);
