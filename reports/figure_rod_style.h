// reports/figure_rod_style.h
// Names and legends of a rod's solutions, the same in every picture.
#pragma once

#include "reports/rod_show.h"

// "t1 0.98 N, t2 drawn 3 mm (slack), tip force ×0.5"; "no tension"
void rod_label(const rod_show *show, int solution, char *text, size_t size);

typedef enum rod_note { ROD_NOTE_NONE, ROD_NOTE_BEND, ROD_NOTE_CURVATURE } rod_note;

// Up to three columns of solutions with a number each; of a sweep, its lines or its range of
// colours.
void rod_legend(canvas *c, const rod_show *show, box at, rod_note note);
double rod_legend_height(const rod_show *show); // [points]

// The size of the curvature along one solution: at both ends, smallest and where, largest.
typedef struct curvature_range {
    double base, tip, least, largest; // [1/m]
    double at;                        // arclength of the least [m]
} curvature_range;
curvature_range rod_curvature_range(const rod_result *rod, int solution);
