// meshes/outline_move.h
// Outlines moved as a whole: mirrored, scaled, turned about the section's origin.
#pragma once

#include "meshes/shape.h"

typedef struct outline_motion {
    bool mirror;  // first: y -> -y
    double scale; // then
    double angle; // then, counter-clockwise [rad]
    bool turning; // the angle varies along the rod: axes of the section turn with it also where it
                  // is 0
} outline_motion;

void section_outline_move(section_outline *o, const outline_motion *motion);

status section_outline_copy(const section_outline *in, section_outline *out);

// The turn of the pattern from a to b: every shape with a direction of its own turned by the same
// angle about the origin, to `tolerance` [rad]. false where they do not agree; *angle is 0 then,
// and where no shape has a direction.
bool section_outline_spin(const section_outline *a, const section_outline *b, double tolerance,
                          double *angle);
