// Images of materials -> a conforming graded mesh of quadrangles and triangles.
#pragma once

#include "meshes/mesher.h"
#include "meshes/pixel_image.h"

// Squares of one material that grow away from its boundaries, halves next to quarters through
// triangles. Pixels that touch at a corner only are not joined there. Of the options order and
// size: no element is larger; 0: a 16th of the image at most. `smoothed`: see pixel_smooth.h.
// ERR_INPUT where there are too many.
status pixel_mesh_make(const pixel_image *p, const mesh_options *options, bool smoothed, mesh *out);
