// section/node_graph.h
// Which nodes of a mesh share an element.
#pragma once

#include "base/mesh.h"
#include "section/cholmod_door.h"

// A lower triangle without values, node i of the mesh being number rank[i], or i where rank is
// NULL; the caller's to free.
status node_graph_make(const mesh *m, const int *rank, sparse_lower *graph);
