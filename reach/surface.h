// reach/surface.h
// The wall of the space in which a scope moves: a closed surface of triangles.
#pragma once

#include "base/dense.h"
#include "base/status.h"

#include <stddef.h>

typedef struct surface {
    int nvertex, ntriangle;
    double (*vertex)[3];    // [nvertex] [m]; vertices at one place are one
    int (*triangle)[3];     // [ntriangle] counter-clockwise seen from outside the enclosed space
    int (*across)[3];       // [ntriangle] 3 t + k: beyond its edge k (from corner k to k + 1) lies
                            // triangle t, whose edge k it is
    double low[3], high[3]; // the box around it [m]
    double area, volume;    // [m^2, m^3]; volume > 0
} surface;

enum { SURFACE_MOST_TRIANGLES = 5 * 1000 * 1000, SURFACE_MOST_PARTS = 64 };

typedef struct surface_options {
    const char *path; // for messages
    double merge;     // vertices within this are one place [m]; at least 1e-7 of the box's diagonal
} surface_options;

typedef struct surface_report {
    double merge;   // what was one place [m]
    int merged;     // corners less the vertices that they became
    int degenerate; // triangles with two corners at one place, left out
    int flipped;    // edges turned because a triangle there had three corners on one line
    int turned;     // triangles whose sense was turned round
    int parts;      // closed pieces
    int inner;      // of them, those that bound an island within another
} surface_report;

// From corners as files have them ([ntriangle][3], in m): merges vertices, turns triangles alike
// and checks. Pieces within pieces bound islands: what is enclosed lies between them. ERR_FILE with
// what, how often and where in mm: open edges, more than two triangles at an edge, sheets that
// touch at a vertex, a one-sided piece, a piece that encloses nothing, triangles that cross or
// touch.
status surface_make(int ntriangle, const double (*corner)[3][3], const surface_options *options,
                    surface *out, surface_report *report);
void surface_free(surface *s);

// of the box around it [m]
double surface_diagonal(const surface *s);

// ERR_INPUT where a scope of this length [m] and this surface differ in size as only units do: by
// more than SURFACE_SIZES either way.
status surface_check_size(const surface *s, const char *path, double length);
enum { SURFACE_SIZES = 50 };

static inline vec3 surface_vertex(const surface *s, int i)
{
    return (vec3){{s->vertex[i][0], s->vertex[i][1], s->vertex[i][2]}};
}

static inline void surface_corners(const surface *s, int t, vec3 corner[3])
{
    for (int k = 0; k < 3; k++) {
        corner[k] = surface_vertex(s, s->triangle[t][k]);
    }
}
