// meshes/loops.h
// Closed loops of curves, as ellipses, splines and drawings are made of.
#pragma once

#include "meshes/polygon.h"
#include "meshes/shape.h"

typedef struct curve_loop {
    int n;
    carrier *piece; // [n]
} curve_loop;

// Loop k of an outline of KIND_LOOPS, a view into it.
curve_loop outline_curves(const outline *o, int k);

double curves_area(curve_loop a); // > 0 where it turns counter-clockwise
void curves_reverse(curve_loop a);
bool curves_contain(curve_loop a, double x, double y);
// Largest distance from the origin, to a part in a thousand.
double curves_reach(curve_loop a);

// A loop as corners on it, near enough to tell whether curves cross; no edge is as short as `gap`
// unless a piece is.
typedef struct flat_loop {
    loop corners;
    int *piece; // [corners.n] which piece an edge is of
} flat_loop;
status curves_flatten(curve_loop a, double gap, flat_loop *out);
void flat_loop_free(flat_loop *f);

// Puts all loops of an outline the right way round. ERR_INPUT where one crosses itself or another
// or all but touches it, or a hole lies outside of the first.
status outline_check_curves(outline *o);
