// Materials on a raster of equal rectangles, the pixels.
#pragma once

#include "base/status.h"

#include <stdbool.h>

enum { PIXEL_NONE = -1 };

typedef struct pixel_image {
    int n[2];         // pixels along x and y
    double pitch[2];  // size of a pixel [m]
    double corner[2]; // lower left corner of the image [m]
    short *at;        // [n[1]][n[0]] material of a pixel or PIXEL_NONE, the bottom row first
} pixel_image;

// Nothing but PIXEL_NONE, centred at the origin.
status pixel_image_make(int nx, int ny, const double pitch[2], pixel_image *out);
void pixel_image_free(pixel_image *p);

// PIXEL_NONE outside too.
static inline int pixel_at(const pixel_image *p, int i, int j)
{
    const bool inside = i >= 0 && j >= 0 && i < p->n[0] && j < p->n[1];
    return inside ? p->at[(long)j * p->n[0] + i] : PIXEL_NONE;
}

// Every pixel as factor x factor equal ones.
status pixel_image_finer(const pixel_image *p, int factor, pixel_image *out);

// Pixels twice as wide, with what most of the four there are; where two are level, the one and the
// other by turns, as on a chessboard.
status pixel_image_coarser(const pixel_image *p, pixel_image *out);

// A part of an image that hangs together through the sides of its pixels.
typedef struct pixel_part {
    int count;    // of its pixels; 0: there is none
    int at[2];    // one of them, column and row from the lower left
    bool touches; // the corner of a pixel of another part
} pixel_part;

// *solid: pixels with material. *apart: the smallest part where they do not all hang together.
status pixel_image_parts(const pixel_image *p, int *solid, pixel_part *apart);
