// reports/segment_surface.h
// The outer surface of an extruded segment, cut into small flat facets that a painter can sort.
#pragma once

#include "base/dense.h"
#include "reports/plane_edges.h"
#include "reports/result.h"

// An orthographic view: x to the right, y up on the paper, the third axis towards the eye. Unit
// vectors, right-handed.
typedef struct camera {
    vec3 right, up, eye;
} camera;

// azimuth: of `right` from x, about z; elevation: of the eye above the section's plane [rad].
camera camera_from(double azimuth, double elevation);
vec3 camera_see(const camera *c, vec3 p);

typedef struct facet {
    int ncorner;     // 3 or 4
    double at[4][2]; // on the paper [m], x right, y up
    double depth;    // of its middle, towards the eye [m]
    double light;    // cosine between its normal and the light, -1..1
    double value;    // size of the displacement there [m]
    bool border;     // materials meet along the side from corner 0 to the last corner
} facet;

typedef struct segment_surface {
    int count;
    facet *facet; // those that face the eye, the farthest first
} segment_surface;

// displacement [solid nnode][3] is multiplied by `magnify` before it is added; `value` stays as it
// is.
status segment_surface_make(const run_result *r, const plane_edges *edges,
                            const double *displacement, double magnify, const camera *camera,
                            segment_surface *out);
void segment_surface_free(segment_surface *s);

// Largest size of a displacement over the surface's nodes [m].
double segment_largest_displacement(const run_result *r, const double *displacement);
