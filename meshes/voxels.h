// meshes/voxels.h
// The slices of a stack of images as voxels: one plane mesh of all places where any slice has
// matter, and what is there in each layer. docs/theory.md (5.16)
#pragma once

#include "meshes/drawing.h"

// Squares of the asked size, in whole pixels or whole parts of one; 0: at most so many across the
// image that the stack stays within reach.
typedef struct voxel_request {
    int first, last; // slices
    int order;
    double size; // [m]
} voxel_request;

// ERR_INPUT where the drawing is no stack of images, or for too many squares.
status voxel_plane(const drawing *d, const voxel_request *ask, mesh *out);

// What the mesh's elements are made of in a slice, -1: nothing. A square has what most of its
// pixels have. plane: by voxel_plane, since then turned and scaled about the origin.
status voxel_matter(const drawing *d, int slice, const mesh *plane, double turn, double scale,
                    int *matter);

// ERR_INPUT, with the slice by `slice_of` a layer, where matter does not hang together with the
// base's by whole faces. matter [nlayer][elements].
status voxel_check(const mesh *plane, int nlayer, const int *matter, const int *slice_of);
