// meshes/edge_pieces.h
// Triangles cut into thin ones and quads along the sides that ask for layers: docs/theory.md (8.6).
#pragma once

#include "meshes/curved.h"
#include "meshes/mesher.h"

// a layer's length falls by SIZING_GROWTH each: no more make sense
enum { EDGE_MOST_LAYERS = 8 };

// A triangle or a quad within one triangle: its corners counter-clockwise, numbered over all
// pieces, and where they are in the triangle. A triangle has its third corner twice.
typedef struct edge_piece {
    int triangle, n;
    int corner[4];
    double bary[4][3];
} edge_piece;

typedef struct edge_pieces {
    int ncorner, npiece; // the first corners are the nodes that were there
    edge_piece *piece;
} edge_pieces;

// first_of: [sides->edges.nedge] thickness of the first layer along each edge, in the units of
// `pieces`; 0 for none. Layers grow by SIZING_GROWTH while a quarter of the triangles takes them.
status edge_pieces_make(const plane_pieces *pieces, const curved_sides *sides,
                        const double *first_of, edge_pieces *out);
void edge_pieces_free(edge_pieces *e);

// Nodes of order p at the places that the triangles' own curved shapes give them. *owner as in
// mapped.h.
status edge_mesh_make(const plane_pieces *pieces, const section_outline *o,
                      const curved_sides *sides, const mesh_options *options, mesh *out,
                      int **owner);
