// meshes/outline.h
// Plane geometry of frozen shapes: which shape lies on top at a point, and how messages name a
// shape.
#pragma once

#include "meshes/shape.h"

// Lengths below this part of the section's size are one and the same: rounding of the input's own
// arithmetic.
#define OUTLINE_MERGE 1e-9
// Parts thinner than this of the section's size are slivers: no element of good shape fits, and no
// printer makes them.
#define OUTLINE_SLIVER 1e-5

// ERR_INPUT at the shape's place in the case: "shape 2 (sector): " + words
status outline_fail(const outline *o, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

// Edges count as inside, to rounding.
bool outline_contains(const outline *o, double x, double y);

// Index of the shape on top at a point, -1 where there is none. It may be one that cuts (material
// -1).
int section_top_shape(const section_outline *o, double x, double y);

// Largest distance of the shape from the origin [m]; a sector counts as its full ring.
double outline_reach(const outline *o);

// Corners of a rectangle, counter-clockwise.
void rectangle_corners(const outline *o, double corner[4][2]);

// angle - 2 pi n, in [-pi, pi]
double angle_fold(double angle);
