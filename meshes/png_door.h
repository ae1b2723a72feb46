// The one door to libpng: bytes in, colours out.
#pragma once

#include "base/input_file.h"

enum { PNG_MOST_SIDE = 1 << 16, PNG_MOST_PIXELS = 1 << 24 }; // 4096 x 4096

typedef struct colour_image {
    int width, height;
    unsigned char *rgba; // [height][width][4], the top row first
} colour_image;

// Any colour type, depth and interlacing. ERR_FILE, with the byte, where the content is not a sound
// PNG image or has more than PNG_MOST_PIXELS.
status png_door_read(const input_file *f, colour_image *out);
void colour_image_free(colour_image *image);
