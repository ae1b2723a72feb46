// meshes/grid.h
// One polar or Cartesian grid of the outlines' own edges: each cell belongs to one shape or to
// none.
#pragma once

#include "meshes/shape.h"

typedef struct grid {
    bool polar; // directions: radius, angle from `angle`; else x and y of axes turned by `angle`
    double centre[2]; // of the rings; the origin for a Cartesian grid [m]
    double angle;     // [rad]
    int n[2];         // cells in each direction
    double *at[2];    // [n + 1] breaks, ascending [m; rad]. Angles run from 0 to 2 pi, and the grid
                      // closes there
    int *owner;       // [n[1]][n[0]] the shape on top if it has a material, else -1
} grid;

// *found false where the outlines lie on no grid, where the grid would have cells thinner than a
// sliver, or where it would need a cell at the centre of the rings; `out` is zeroed then.
status grid_make(const section_outline *o, grid *out, bool *found);
void grid_free(grid *g);

// The point at the two coordinates of the grid.
void grid_point(const grid *g, double a, double b, double *xy);
