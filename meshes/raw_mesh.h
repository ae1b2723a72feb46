// meshes/raw_mesh.h
// Plane elements as gmsh knows them, from a file or from gmsh itself, and what becomes of them: a
// mesh of ours, checked.
//
// gmsh's nodes lie equally spaced along edges, vertices first, then edges, then inside, ring by
// ring; ours are the lattice of Gauss-Lobatto points of base/element.h.
#pragma once

#include "base/input_file.h"
#include "base/mesh.h"

#include <stdint.h>

typedef struct raw_element {
    shape shape; // triangle or quad
    int first;   // into conn
    int material;
    int frame;  // -1: the section's own
    int64_t id; // the file's name for it
} raw_element;

typedef struct raw_mesh {
    const input_file *file; // for messages
    int order;
    double unit;   // of xyz [m]
    int nnode;     // some may be unused
    double *xyz;   // [nnode][3], in `unit`
    double *exact; // [nnode][3] our places of nodes of edges where they are known, else NaN; NULL:
                   // nowhere
    int64_t *node_id; // [nnode] the file's names
    int nelem;
    raw_element *elem; // [nelem]
    int nconn;
    int *conn; // [nconn] nodes, gmsh's order
    int nframe;
    material_frame *frame; // [nframe]; lengths in m
} raw_mesh;

void raw_mesh_free(raw_mesh *r);

// ERR_FILE where the elements make no section: not in a plane z = constant, edges that do not fit
// together, parts that do not hang together, nodes that coincide, inverted elements. Elements that
// are turned over are turned back; nodes without elements are left out.
status raw_mesh_finish(const raw_mesh *r, mesh *out);

// The same without the last check: elements may be inverted.
status raw_mesh_make(const raw_mesh *r, mesh *out);

// Place of gmsh's node i on the lattice of base/element.h: lattice[i], for i < node count.
void raw_lattice(shape shape, int order, int *lattice);
