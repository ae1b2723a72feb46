// measure/line_fit.h
// Parabolas by least squares through a few places of a line, and what errors that go together along
// it add up to; for measure/shape_error.c and its neighbours.
#pragma once

#include "measure/centreline.h"

typedef struct line_fit {
    vec3 place, slope, bend; // value and derivatives at the place asked for
} line_fit;

// A parabola through n places (a straight line of two), each component by least squares.
line_fit line_fit_at(int n, const double *s, const vec3 *p, double at);
// The weight of each place in `slope` and in `bend` [n].
void line_fit_slope_weights(int n, const double *s, double at, double *weight);
void line_fit_bend_weights(int n, const double *s, double at, double *weight);

// The variance of sum part_i . e_i, where the three components of e have deviation 1 and go
// together like exp(-|s_i - s_k| / length); length NAN: not at all. s in ascending or descending
// order.
//   docs/theory.md (9.55)
double correlated_variance(int n, const double *s, const vec3 *part, double length);
