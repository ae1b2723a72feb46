// Images of materials -> a conforming graded mesh of quadrangles and triangles.
#pragma once

#include "meshes/mesher.h"
#include "meshes/pixel_image.h"

typedef struct pixel_mesh_request {
    const mesh_options *options; // order; size: no element is larger, 0: one pixel at the smallest
    const double *shift;         // [n[1] + 1][n[0] + 1][2] how far pixels' corners are moved, in
                                 // pixels; NULL: nowhere
} pixel_mesh_request;

// Squares of one material that grow away from its boundaries, halves next to quarters through
// triangles. Pixels that touch at a corner only are not joined there. ERR_INPUT where there are too
// many.
status pixel_mesh_make(const pixel_image *p, const pixel_mesh_request *request, mesh *out);
