// reports/figure_rod_scene.h
// Rods in space with what acts on them, drawn the same way from every side.
#pragma once

#include "reports/rod_show.h"
#include "reports/segment_surface.h"

typedef struct rod_scene {
    const run_result *r;
    const rod_show *show;
    double size;                                // largest extent of the shapes [mm]
    double least[3], most[3];                   // of all that is drawn [mm]
    double force, moment, density, line_moment; // the largest on any shape drawn with its loads
} rod_scene;

typedef struct rod_view {
    canvas *c;
    camera camera;
    double x0, y0, scale; // points of the origin, points per mm
    bool tendons;         // drawn too
} rod_view;

rod_scene rod_scene_make(const run_result *r, const rod_show *show);

void rod_view_at(const rod_view *v, vec3 mm, double at[2]);
void rod_view_line(const rod_view *v, vec3 from, vec3 to);

void rod_scene_draw(const rod_scene *s, const rod_view *v);

// Whatever a view must hold [mm]; the arrows' ends included.
typedef void rod_point_visit(vec3 mm, void *data);
void rod_scene_points(const rod_scene *s, rod_point_visit *visit, void *data);

// --- reports/figure_rod_loads.c

typedef struct rod_arrow {
    vec3 from, to; // [mm]
    bool follower, moment;
    bool many; // one of those along a line
} rod_arrow;

typedef void rod_arrow_visit(const rod_arrow *a, void *data);
void rod_loads_measure(rod_scene *s);
void rod_loads_visit(const rod_scene *s, rod_arrow_visit *visit, void *data);
void rod_loads_draw(const rod_scene *s, const rod_view *v);

// The direction of gravity in the emptiest corner of a view; nothing where there is none.
void rod_gravity_draw(const rod_scene *s, const rod_view *v, box at);

// What acts, in words.
double rod_loads_legend_height(const rod_result *rod);
void rod_loads_legend(canvas *c, const rod_result *rod, box at);
