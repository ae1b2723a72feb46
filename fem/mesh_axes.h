// fem/mesh_axes.h
// Axes that turn with the nodes of a body's levels. A section's own axes need not: a strip that
// winds round a tube takes the mesh along, not the tube. docs/theory.md (5.14c)
#pragma once

#include "fem/body.h"

// Angle about the section's normal by which nodes at xyz [nnode][3] are turned against the plane
// mesh, in the mean square.
double mesh_angle(const mesh *plane, const double *xyz, mat3 axes, const double origin[3]);

// Of a level that is held.
mat3 mesh_axes(const body *b, int level);
