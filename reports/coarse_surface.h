// reports/coarse_surface.h
// Fewer triangles of about the same shape, for pictures: vertices in one cell of a grid become one,
// at their mean (Rossignac and Borrel 1993).
#pragma once

#include "base/status.h"

typedef struct coarse_surface {
    int nvertex, ntriangle;
    double (*vertex)[3];
    int (*triangle)[3];
} coarse_surface;

// At most `most` triangles, on the finest grid that does it; the surface itself where it has no
// more. Vertices that are no numbers go with their triangles.
status coarse_surface_make(int nvertex, const double (*vertex)[3], int ntriangle,
                           const int (*triangle)[3], int most, coarse_surface *out);
void coarse_surface_free(coarse_surface *c);
