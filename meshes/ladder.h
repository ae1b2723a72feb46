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

typedef struct ladder_steps {
    double target;  // longest element
    double growth;  // of the elements away from a break that asks for fine ones
    double stretch; // by what the elements beyond may exceed the next one of that growth
} ladder_steps;

// at: [ncell + 1] breaks. finest: [ncell + 1] length of the elements next to a break, 0 where it
// asks for none; they grow away from it, up to the target, which is kept elsewhere.
status ladder_make(int ncell, const double *at, const double *finest, const ladder_steps *steps,
                   ladder *out);
void ladder_free(ladder *l);
