// meshes/morph_curves.h
// The closed curves that bound the shapes of a section, each with one parameter along it.
#pragma once

#include "meshes/shape.h"

// A closed curve of pieces; a place on it is piece + part, 0 <= part <= 1.
typedef struct shape_curve {
    int shape, first, n; // pieces first .. first + n - 1
} shape_curve;

typedef struct shape_curves {
    int ncurve, npiece;
    shape_curve *curve; // of the shapes in order
    carrier *piece;
} shape_curves;

// turn: what full circles, which have no direction of their own, begin at [rad]
status shape_curves_make(const section_outline *o, double turn, shape_curves *out);
void shape_curves_free(shape_curves *c);

// The point at a place, which may lie outside of 0..n: the curve is closed.
void shape_curve_point(const shape_curves *c, int curve, double place, double x[2]);
// Its derivative over the place.
void shape_curve_slope(const shape_curves *c, int curve, double place, double dx[2]);
// Nearest place; returns the distance [m].
double shape_curve_nearest(const shape_curves *c, int curve, const double x[2], double *place);
// Whether the curve turns sharply at the begin of piece k.
bool shape_curve_has_corner(const shape_curves *c, int curve, int k);
