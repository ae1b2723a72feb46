// meshes/curved.h
// Straight triangles along known circles -> triangles of order p whose edges follow the circles.
#pragma once

#include "base/mesh.h"
#include "meshes/edges.h"
#include "meshes/gmsh_door.h"
#include "meshes/shape.h"

// The curve that a side of a triangle follows, and the circle that this is a part of.
typedef struct bend {
    int curve; // -1: the side lies on no curve
    int round; // else whether it bends
    double centre[2];
} bend;

typedef struct curved_sides {
    edge_list edges;
    bend *bend; // [edges.nedge]
} curved_sides;

// ERR_NUMERIC where a bent curve belongs to no circle of the outlines. Same units in `pieces` and
// `o`.
status curved_sides_make(const plane_pieces *pieces, const section_outline *o, curved_sides *out);
void curved_sides_free(curved_sides *s);

// Area of a triangle with its bent sides, exact.
double curved_triangle_area(const plane_pieces *pieces, const curved_sides *s, int triangle);

// The point of a triangle with its bent sides at barycentric coordinates, exact on the sides.
void curved_triangle_point(const plane_pieces *pieces, const curved_sides *s, int triangle,
                           const double bary[3], double *x);

// Nodes of bent sides are the Lobatto points of the arc itself, so that the area's error falls with
// (arc of a side)^(2p); inside, the bulges of the sides are blended. Coordinates are multiplied by
// `scale`.
status curved_mesh_make(const plane_pieces *pieces, const section_outline *o, const curved_sides *s,
                        int order, mesh *out);
