// reports/figure_reach.h
// What the pictures of a reach study share.
#pragma once

#include "reports/figure_kit.h"
#include "reports/wall_view.h"

// from the front (along y), from the side (along -x), from above (along -z)
enum { REACH_VIEWS = 3, REACH_BODIES = 40 }; // of a scope, in a picture at most
camera reach_camera(int view);
const char *reach_camera_name(int view); // "from the front: x to the right, z up"

static inline vec3 reach_vec(const double p[3])
{
    return (vec3){{p[0], p[1], p[2]}};
}

// "18 of 20 targets reached"
const char *reach_count_words(const reach_result *r, int scope, char words[REACH_TEXT]);

// Where the anatomy comes from, and that it is synthetic where it is.
void reach_source_line(canvas *c, double x, double y, double width, const run_result *r);

// x, y and z as the camera sees them, from (x, y).
void reach_axes(canvas *c, const camera *camera, double x, double y);

// --- reports/figure_reach_panel.c

typedef struct reach_side {
    wall_view view;
    wall_shade shade;
    double low[2], high[2]; // what is shown [m]
} reach_side;

// One view of one scope.
typedef struct reach_panel {
    canvas *c;
    const reach_result *r;
    const reach_scope_result *scope;
    const reach_side *side;
    box at;
    double scale; // [points per m]
    double mark;  // radius of a target's mark [points]
} reach_panel;

void reach_panel_draw(const reach_panel *p);
void reach_cross_path(canvas *c, const double at[2], double r);
