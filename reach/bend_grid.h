// reach/bend_grid.h
// A coarse map of where the tip gets as its bending joints go through their ranges: a grid over
// them, and for every cell the distances from the line and along it that its tips have.
//                                                                       docs/theory.md (10.4)
#pragma once

#include "reach/scope.h"

typedef struct grid_cell {
    double middle[SCOPE_TENDONS]; // bending joints
    double rho[2], z[2];          // least and most, what the cell's curvature may add included [m]
} grid_cell;

typedef struct bend_grid {
    int nbend, per_joint, ncell; // nodes along each joint
    grid_cell *cell;
    double spacing; // between the tips of two neighbouring nodes, largest [m]
} bend_grid;

// ERR_NUMERIC where the scope's rod has no equilibrium within the joints' limits.
status bend_grid_make(scope_state *state, bend_grid *out);
void bend_grid_free(bend_grid *g);
