// reach/surface_line.h
// Where a straight line passes through a surface.
#pragma once

#include "reach/surface.h"

typedef struct surface_passage {
    double along; // from p, in the line's direction; negative: behind p [m]
    int triangle;
    bool inward; // into the enclosed space
} surface_passage;

// All passages, ascending; *n is even, 0 where the line misses the surface. In and out by turns: a
// line through an edge or a corner passes it once or not at all. To be freed with free.
status surface_line(const surface *s, vec3 p, vec3 direction, surface_passage **out, int *n);
