// section/node_graph.h
// Which nodes of a mesh share an element.
#pragma once

#include "base/mesh.h"
#include "section/cholmod_door.h"

// A lower triangle without values; the caller's to free.
status node_graph_make(const mesh *m, sparse_lower *graph);
