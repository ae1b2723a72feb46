// section/plane.h
// One element of a plane mesh at a time, at all quadrature points, in lengths of the section's own
// size: the kernels then see numbers near 1 for sections of nanometres and of kilometres alike.
#pragma once

#include "base/mesh.h"

enum { ELEMENT_MAX_PLANE_POINTS = 100 }; // of the rules up to degree 4 * 4 + 1

typedef struct plane {
    const mesh *mesh;
    double centre[2]; // the origin of the scaled coordinates [m]: the bounding box's middle
    double length;    // half the bounding box's diagonal: their unit [m]
    double *xy;       // [nnode][2] scaled
    basis_table table[MESH_MAX_BLOCKS];
    double *room; // the arrays of the one element
} plane;

// The arrays stand until the next plane_element_at.
typedef struct plane_element {
    int block, index;
    int nnode, npoint;
    int material;
    const int *node;    // [nnode]
    const double *N;    // [npoint][nnode]
    double *Nx, *Ny;    // [npoint][nnode] derivatives along x and y
    double *x, *y, *dA; // [npoint] place and weight times det J
} plane_element;

// The mesh stays the caller's and must outlive the plane. ERR_NUMERIC where it is not plane or has
// no extent.
status plane_make(const mesh *m, int degree, plane *out);
void plane_free(plane *p);

// Takes the section's own origin for that of the scaled coordinates.
void plane_use_origin(plane *p);

// ERR_NUMERIC where det J is not positive at a quadrature point.
status plane_element_at(plane *p, int block, int index, plane_element *out);
