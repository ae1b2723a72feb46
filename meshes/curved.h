// meshes/curved.h
// Straight triangles along known curves -> triangles of order p whose edges follow the curves.
#pragma once

#include "base/mesh.h"
#include "meshes/edges.h"
#include "meshes/gmsh_door.h"
#include "meshes/shape.h"

// What a side of a triangle follows.
typedef struct bend {
    int curve;    // of the pieces; -1: the side lies on no curve
    int on;       // index into `carrier`; -1: it is straight
    double at[2]; // the carrier's parameter at the edge's two ends
} bend;

typedef struct curved_sides {
    edge_list edges;
    bend *bend; // [edges.nedge]
    int ncarrier;
    carrier *carrier; // all curves of the outlines that bend
} curved_sides;

// ERR_NUMERIC where a bent curve belongs to no curve of the outlines. Same units in `pieces` and
// `o`.
status curved_sides_make(const plane_pieces *pieces, const section_outline *o, curved_sides *out);
void curved_sides_free(curved_sides *s);

// Area of a triangle with its bent sides, to rounding.
double curved_triangle_area(const plane_pieces *pieces, const curved_sides *s, int triangle);

// The point at t in [0, 1] of an edge, from its smaller node.
void curved_side_point(const plane_pieces *pieces, const curved_sides *s, int edge, double t,
                       double *x);

// The point of a triangle with its bent sides at barycentric coordinates, exact on the sides.
void curved_triangle_point(const plane_pieces *pieces, const curved_sides *s, int triangle,
                           const double bary[3], double *x);

// Nodes of bent sides are the Lobatto points of the carrier's own smooth parameter, so that the
// area's error falls with (arc of a side)^(2p), and cubics are met exactly from p = 3 on; inside,
// the bulges of the sides are blended. Coordinates are multiplied by `scale`.
status curved_mesh_make(const plane_pieces *pieces, const section_outline *o, const curved_sides *s,
                        int order, mesh *out);
