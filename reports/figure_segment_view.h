// reports/figure_segment_view.h
// One deformed segment on paper.
#pragma once

#include "reports/figure_kit.h"
#include "reports/segment_surface.h"

typedef struct segment_scene {
    const run_result *r;
    plane_edges edges; // of the plane mesh
    plane_loops loops; // of the whole section
    camera camera;
    double magnify;         // of the displacements in the picture
    surface_value value;    // what the colours are
    double largest;         // end of their common scale [m], [Pa]
    double low[2], high[2]; // what all loads together take on the paper [m]
    bool fig4;
    bool borders; // the section has more than one material
} segment_scene;

// Chooses the view, the magnification and the common scales.
status segment_scene_make(const run_result *r, surface_value value, segment_scene *out);
void segment_scene_free(segment_scene *s);

colour segment_colour(const segment_scene *s, double value, double light);

// points_per_m: the same for all loads, so that they compare.
status segment_view(canvas *c, const segment_scene *s, int load, box at, double points_per_m);
