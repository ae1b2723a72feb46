// meshes/plane_shapes.h
// Outlines -> loops of lines and arcs in units of the section's size, as the gmsh module takes
// them.
#pragma once

#include "meshes/gmsh_door.h"
#include "meshes/shape.h"

// Fills the shapes of *out and leaves the rest of it alone.
status plane_shapes_make(const section_outline *o, plane_request *out);
void plane_request_free(plane_request *r);
