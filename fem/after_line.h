// fem/after_line.h
// Functions given at the heights of a run: their slopes along the body.
#pragma once

#include "base/dense.h"
#include "base/status.h"

typedef struct after_line {
    int n;
    const double *z; // [n] ascending [m]
    int order; // the points are the Gauss-Lobatto points of layers of this order; 0: any points
} after_line;

// df/dz at all points. Layers: the derivative of each layer's polynomial at its Gauss points, where
// it is best, and a polynomial through the nearest of them. docs/theory.md (5.20)
status line_slopes(const after_line *line, const vec6 *f, vec6 *slope);

// Least-squares slope of f over centre - half .. centre + half, (5.3).
vec6 line_mean_slope(const after_line *line, const vec6 *f, double centre, double half);
