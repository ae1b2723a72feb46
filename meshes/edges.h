// meshes/edges.h
// The edges of plane elements, each once, and what hangs together through them.
#pragma once

#include "base/mesh.h"
#include "meshes/shape.h"

typedef struct edge_list {
    int nside;     // sides of an element, 3 or 4
    int nedge;     // different edges
    int *of;       // [elements][nside] edge of side k, which joins corners k and k + 1
    int (*end)[2]; // [nedge] its two nodes, the smaller first
    int *count;    // [nedge] elements that share it
} edge_list;

// corner: [nelem][nside] nodes, in order around the element; a side between equal nodes is none,
// and its edge -1
status edge_list_make(int nelem, int nside, const int *corner, edge_list *out);
void edge_list_free(edge_list *e);

// The corners of all elements, block after block, in order around each; triangles among quads have
// their last one twice. *corner [elements][*nside] is the caller's to free.
status mesh_corners(const mesh *m, int *nside, int **corner);

// ERR_INPUT where elements do not hang together through whole edges, naming a shape that stands
// apart; owner as in mapped.h. ERR_NUMERIC where more than two elements share an edge.
status mesh_check_connected(const mesh *m, const int *owner, const section_outline *o);
