// meshes/sizing.h
// How large elements are where the case does not say so, and at most.
#pragma once

#include "meshes/mesher.h"

enum { SECTION_MOST_ELEMENTS = 200000 };

// Target edge length [m].
double sizing_length(const mesh_options *options, double section_size);

// Largest angle of an arc that one element edge follows [rad].
double sizing_angle(const mesh_options *options);

// How many equal parts of at most `target` make up `length`; at least one. Rounding does not add a
// part.
double sizing_parts(double length, double target);
