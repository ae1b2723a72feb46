// reach/triangle.h
// Triangles in space, in double.
#pragma once

#include "base/dense.h"

#include <stdbool.h>

// Where on a triangle a point lies: inside, on the edge from corner k to corner k + 1, or at a
// corner k.
typedef enum triangle_place { ON_FACE, ON_EDGE = 1, ON_CORNER = 4 } triangle_place; // + k

// The point of a triangle that is nearest to p; *place ON_FACE, ON_EDGE + k or ON_CORNER + k.
vec3 triangle_nearest(const vec3 corner[3], vec3 p, int *place);

// (b - a) x (c - a): twice the area, along the normal
vec3 triangle_normal(const vec3 corner[3]);

// The angle at corner k.
double triangle_angle(const vec3 corner[3], int k);

// The solid angle under which p sees it, negative where it turns clockwise [sr].
double triangle_solid_angle(const vec3 corner[3], vec3 p);

// Whether a plane parts two triangles by more than `gap` (of segments: np or nq = 2).
bool triangles_apart(int np, const vec3 *p, int nq, const vec3 *q, double gap);
