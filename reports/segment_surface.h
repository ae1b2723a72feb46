// reports/segment_surface.h
// The outer surface of a segment, cut into small flat facets that a painter can sort.
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
    double value;    // size of the displacement there [m], or von Mises stress [Pa]
    bool border;     // materials meet along the side from corner 0 to the last corner
} facet;

typedef struct segment_surface {
    int count;
    facet *facet; // those that face the eye, the farthest first
} segment_surface;

typedef enum surface_value { SURFACE_DISPLACEMENT, SURFACE_MISES } surface_value;

// Displacements are multiplied by `magnify` before they are added; `value` stays as it is. The
// segment has all its levels here, and stresses where those are wanted.
status segment_surface_make(const segment_body *body, const segment_load_result *load,
                            surface_value value, double magnify, const camera *camera,
                            segment_surface *out);
void segment_surface_free(segment_surface *s);

// Largest value over the nodes; of stresses, which clamped edges concentrate without bound as
// meshes get finer, between a tenth of the length from either end.
double segment_largest(const segment_body *body, const segment_load_result *load,
                       surface_value value);
