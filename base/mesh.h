// base/mesh.h
// A mesh: nodes and blocks of equal elements, a material per element. Plane meshes keep z = 0.
#pragma once

#include "base/element.h"
#include "base/material_frame.h"
#include "base/status.h"

enum { MESH_MAX_BLOCKS = 2 };

typedef struct mesh_block {
    shape shape;
    int nelem;
    int per_elem;  // nodes per element
    int *conn;     // [nelem][per_elem], lattice order of base/element.h, from 0
    int *material; // [nelem], index into the case's materials
    int *frame;    // [nelem], index into the mesh's frames, -1 for the section's own; NULL: all of
                   // them its own (1 = z, 2 = x, 3 = y)
} mesh_block;

typedef struct mesh {
    int dim;   // 2 or 3
    int order; // of every element, 1..4
    int nnode;
    double *xyz; // [nnode][3] [m]
    int nblock;
    mesh_block block[MESH_MAX_BLOCKS];
    int nframe;
    material_frame *frame; // [nframe] directions of materials; NULL where no element has its own
} mesh;

// Room for nnode nodes and one block per (shape, nelem) given; zeroed. Owned by the caller:
// mesh_free.
status mesh_make(int order, int nnode, int nblock, const shape *shapes, const int *nelem,
                 mesh *out);
status mesh_copy(const mesh *in, mesh *out);
void mesh_free(mesh *m);

// Room for nframe frames and an index for every element, -1 to begin with.
status mesh_take_frames(mesh *m, int nframe);

int mesh_element_count(const mesh *m);

// The same plane or solid geometry at another order, nodes evaluated from the given ones: a lower
// one for error estimates, a higher one of the same shapes (no rounder).
status mesh_of_order(const mesh *in, int order, mesh *out);

// The smallest det J over all quadrature points and nodes of each element, divided by that
// element's mean det J: 1 for a parallelogram, <= 0 for an inverted element.
status mesh_min_jacobian(const mesh *m, double *min_ratio);

// Every index within range, every node used, finite coordinates, no det J <= 0: else ERR_NUMERIC
// with the element.
status mesh_check(const mesh *m);
