// base/material_frame.h
// Directions of a material's own axes 1 (fibre), 2 and 3 at a point of a section.
#pragma once

#include "base/dense.h"

#include <stdbool.h>

// Rows of `axes` are the directions 1, 2, 3, orthonormal and right-handed, in the section's axes x,
// y, z; where `polar`, in the axes at the point: x' along the circle about `centre` through it,
// counter-clockwise, y' towards the centre, z.
typedef struct material_frame {
    bool polar;
    double centre[2]; // [m]
    mat3 axes;
} material_frame;

// 1 = z along the rod, 2 = x, 3 = y, turned by two angles [rad]: plane_angle turns 2 and 3 about 1
// (from x towards y), then fibre_angle turns 1 and 2 about 3 (the fibre from z towards 2).
material_frame material_frame_make(double plane_angle, double fibre_angle);

// The directions at a point in the section's axes. At the very centre of a polar frame, those to
// the right of it.
mat3 material_frame_axes_at(const material_frame *f, double x, double y);

// T of docs/theory.md (1.7): strains along the rows of `axes` = T strains in x, y, z, either in the
// order 11 22 33 23 13 12 with engineering shear strains. A stiffness turns back as T^T Q T.
mat6 material_frame_strain_map(mat3 axes);

// The same directions after the section was scaled, then turned by `angle` [rad] about its origin.
void material_frame_move(material_frame *f, double scale, double angle);

// Whether two frames are one: axes to `gap`, centres to `gap` times `size` [m].
bool material_frame_is(const material_frame *a, const material_frame *b, double gap, double size);
