// meshes/plane_sizing.h
// Slivers, and how finely the free mesher divides curves: what it asks while it works, see
// gmsh_door.h.
#pragma once

#include "meshes/gmsh_door.h"
#include "meshes/shape.h"

// ERR_INPUT where a shape is a sliver by itself.
status section_check_thickness(const section_outline *o);

// ERR_INPUT where the overlaps leave a sliver or an edge as small as one, or the size asks for too
// many elements.
status plane_check(plane_request *r, const plane_pieces *p);
int plane_parts(const plane_request *r, int curve);
double plane_size_at(int dim, int tag, double x, double y, double z, void *request);

// Adds a place that asks for short edges.
status plane_add_source(plane_request *r, double x, double y, double length);
