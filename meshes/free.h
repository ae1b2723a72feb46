// meshes/free.h
// Any outlines -> curved triangles, by gmsh.
#pragma once

#include "meshes/mesher.h"

// *owner: [elements] the shape that each element belongs to, the caller's to free.
status free_mesh_make(const section_outline *o, const mesh_options *options, mesh *out,
                      int **owner);
