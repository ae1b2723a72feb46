// meshes/corner.h
// Points where the section's solution is not smooth, so that small elements pay: corners of
// materials.
#pragma once

#include "meshes/shape.h"

typedef enum corner {
    CORNER_NONE,   // inside or on a straight edge
    CORNER_WEAK,   // a corner that sticks out, or an interface that ends on a straight free edge
    CORNER_STRONG, // a corner that points inwards, or a corner or meeting of interfaces
} corner;

// What lies around (x, y) within the radius `near` [m], by the materials met on a circle.
corner corner_at(const section_outline *o, double x, double y, double near);
