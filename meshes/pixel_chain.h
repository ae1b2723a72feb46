// The boundaries between the materials of an image, as chains of pixels' corners.
#pragma once

#include "meshes/pixel_image.h"

typedef struct pixel_chain {
    int count;   // of its points
    bool closed; // the last point is joined to the first; else both ends stay where they are
    int *point;  // [count] j * (n[0] + 1) + i of the corner at column i, row j
} pixel_chain;

typedef struct pixel_chains {
    int count;
    pixel_chain *chain;
    int *points; // of all chains
} pixel_chains;

// Chains of the sides of pixels at which the material changes, with points that may move. One ends
// where three
// materials meet, where pixels touch at a corner only, and at corners that are meant: those with
// two straight sides too long for stairs.
status pixel_chains_make(const pixel_image *p, pixel_chains *out);
void pixel_chains_free(pixel_chains *c);
