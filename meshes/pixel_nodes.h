// Triangles and quadrangles with straight sides, given by their corners -> a mesh of any order.
#pragma once

#include "base/mesh.h"

typedef struct straight_cells {
    int npoint;
    double *xy;     // [npoint][2]
    int ncell[2];   // triangles, quadrangles
    int *corner[2]; // [ncell][3 or 4] points, counter-clockwise
    int *material[2];
} straight_cells;

void straight_cells_free(straight_cells *c);

// One block per kind of cell there is, triangles last. Every point must belong to a cell.
status straight_cells_mesh(const straight_cells *c, int order, mesh *out);
