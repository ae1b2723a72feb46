// Which colour of an image is which material.
#pragma once

#include "base/input_file.h"
#include "meshes/drawing.h"
#include "meshes/pixel_image.h"
#include "meshes/png_door.h"

typedef struct png_colour {
    unsigned rgb; // 0xrrggbb
    int material; // index, or PIXEL_NONE
} png_colour;

typedef struct png_parts {
    int count;
    png_colour *colour; // in order of rgb
    mark at;
} png_parts;

// ERR_INPUT, with its place, for what is no colour, no material, or said twice.
status png_parts_make(const png_spec *spec, const drawing_request *request, png_parts *out);
void png_parts_free(png_parts *p);

// Materials of an image, the file's top row being the upper one. Pixels less than half opaque are
// of none. ERR_INPUT for colours that are not among the parts, with the first one's place.
status png_parts_image(const png_parts *p, const input_file *f, const colour_image *image,
                       const double pitch[2], pixel_image *out);
