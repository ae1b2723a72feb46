// reach/distance.h
// How far points are from a surface, and on which side. The tree is Embree's, in single precision
// with radii made larger; what decides is done in double: exact to rounding. The side is that of
// the angle-weighted normal of the face, edge or vertex that is nearest (Baerentzen and Aanaes
// 2005).
#pragma once

#include "reach/surface.h"

typedef struct distance_tree distance_tree;

typedef struct nearest_point {
    double distance; // positive inside the enclosed space, negative outside [m]
    vec3 p;          // the nearest point of the surface
    int triangle;    // it lies on; -1: none (distance_within)
} nearest_point;

// The surface must outlive the tree. Any number of threads may ask at once.
status distance_tree_make(const surface *s, distance_tree **out);
void distance_tree_free(distance_tree *t); // NULL is nothing

nearest_point distance_to(const distance_tree *t, vec3 p);

// The same where the surface is known to be within `radius`: quicker. Where it is not, triangle is
// -1 and distance NAN.
nearest_point distance_within(const distance_tree *t, vec3 p, double radius);

// What is known of the distance without a search: quick.            docs/theory.md (10.23)
typedef struct distance_range {
    double low, high; // it lies between; -INFINITY and INFINITY far outside
    double reach;     // the surface is within this, whatever the side [m]
} distance_range;
distance_range distance_between(const distance_tree *t, vec3 p);
// narrower, and less quick
distance_range distance_between_closely(const distance_tree *t, vec3 p);
