// reports/plane_edges.h
// The sides of a plane mesh's elements: what bounds a region of one material, curved as the
// elements are.
#pragma once

#include "base/mesh.h"

typedef struct plane_edge {
    int node[ELEMENT_MAX_ORDER + 1]; // counter-clockwise around the element it belongs to
    int material;                    // of that element
    int other;                       // of the element across; -1 outside
} plane_edge;

typedef struct plane_edges {
    const mesh *mesh; // kept by reference
    element line;     // basis on one edge
    int count;
    plane_edge *edge; // every side of every element, those around one node in no order
} plane_edges;

status plane_edges_make(const mesh *plane, plane_edges *out);
void plane_edges_free(plane_edges *e);

// The place at t in [-1, 1] along the edge [m].
void plane_edge_point(const plane_edges *e, const plane_edge *edge, double t, double xy[2]);

enum { PLANE_WHOLE = -1 };

// Closed loops of the edges that bound a material, or the whole section for PLANE_WHOLE. The region
// lies to their left, so loops around holes are clockwise.
typedef struct plane_loops {
    int nloop;
    int *start; // [nloop + 1] into order
    int *order; // edge numbers, head to tail
} plane_loops;

status plane_loops_make(const plane_edges *e, int material, plane_loops *out);
void plane_loops_free(plane_loops *l);

// Signed area inside one loop of straight lines through the nodes [m^2]: negative around a hole.
double plane_loop_area(const plane_edges *e, const plane_loops *l, int loop);
