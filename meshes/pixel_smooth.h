// Boundaries between materials smoothed by less than a pixel.
#pragma once

#include "meshes/pixel_image.h"

// How a quadrangle is best divided into elements whose corners stay far from 0 and 180 degrees.
typedef enum cell_cut {
    CUT_NOT,    // one quadrangle
    CUT_FIRST,  // two triangles, between corners 0 and 2
    CUT_SECOND, // between corners 1 and 3
    CUT_FAILS,
} cell_cut;

// xy: corners counter-clockwise; an area of 1 is an undisturbed cell's.
cell_cut cell_cut_of(const double xy[4][2]);

// *shift: [n[1] + 1][n[0] + 1][2] how far the corners of pixels are moved, in pixels, at most half
// of one; the caller's to free. No pixel is turned over.
status pixel_smooth(const pixel_image *p, double **shift);
