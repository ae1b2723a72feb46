// meshes/raw_check.h
// Whether elements of a file make one section.
#pragma once

#include "meshes/raw_mesh.h"

// ERR_FILE where the nodes of elements do not lie in one plane z = constant.
status raw_check_plane(const raw_mesh *r);

// turned: [nelem] elements whose corners go round clockwise. ERR_FILE where corners coincide.
status raw_check_turns(const raw_mesh *r, bool *turned);

// ERR_FILE where an edge has more than two elements, two on the same side, or two that disagree
// about the nodes along it; where a node has two places; where elements do not hang together
// through edges, or nodes of the boundary coincide.
status raw_check_edges(const raw_mesh *r, const bool *turned);

// edge: [nedge][2] ends of the edges with one element. ERR_FILE where different nodes of them are
// at one place, or two straight edges leave a node in the same direction: the mesh looks whole
// there and is cut open.
status raw_check_border(const raw_mesh *r, int nedge, const int *edge);

// The section's size, in the file's unit.
double raw_extent(const raw_mesh *r);
