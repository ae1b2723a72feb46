// Boundaries between materials smoothed by less than a pixel.
#pragma once

#include "meshes/pixel_image.h"

// *shift: [n[1] + 1][n[0] + 1][2] how far the corners of pixels are moved, in pixels, at most half
// of one; the caller's to free. No pixel is turned over.
status pixel_smooth(const pixel_image *p, double **shift);
