// meshes/polygon.h
// Closed loops of straight edges.
#pragma once

#include "meshes/shape.h"

typedef struct loop {
    int n;
    double *p; // [n][2] [m], not closed
} loop;

// Loop k of a polygon's outline, a view into it.
loop outline_loop(const outline *o, int k);

double loop_area(loop a); // > 0 where it turns counter-clockwise
void loop_reverse(loop a);
bool loop_contains(loop a, double x, double y);

// Index of the first edge that is shorter than `gap`, or that comes nearer than `gap` to another
// edge of the loop which is not its neighbour, or that folds back on its neighbour; -1 where there
// is none. *other is the second edge.
int loop_self_contact(loop a, double gap, int *other);

// Whether an edge of a comes nearer than `gap` to an edge of b.
bool loops_touch(loop a, loop b, double gap);
