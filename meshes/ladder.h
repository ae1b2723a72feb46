// meshes/ladder.h
// Element edges along one direction of a grid: the grid's breaks, parts of each interval, finer
// towards corners.
#pragma once

#include "base/status.h"

typedef struct ladder {
    int n;        // elements
    double *edge; // [n + 1]
    int *cell;    // [n] the interval of the grid
} ladder;

// at: [ncell + 1] breaks. finest: [ncell + 1] length of the elements next to a break, 0 where it
// asks for none; they grow by `growth` away from it, up to `target`, which is kept elsewhere.
status ladder_make(int ncell, const double *at, const double *finest, double target, double growth,
                   ladder *out);
void ladder_free(ladder *l);
