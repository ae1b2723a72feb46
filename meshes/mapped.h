// meshes/mapped.h
// A grid's cells -> quads of order p, with nodes placed exactly on the circles and edges.
#pragma once

#include "meshes/grid.h"
#include "meshes/mesher.h"

// *owner: [elements] the shape that each element belongs to, the caller's to free.
status mapped_mesh_make(const section_outline *o, const grid *g, const mesh_options *options,
                        mesh *out, int **owner);
