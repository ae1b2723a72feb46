// reports/figure_rod_style.h
// One colour and one name for each tension of a rod, the same in every picture.
#pragma once

#include "reports/figure_kit.h"
#include "reports/result.h"

// Solutions that pull the same tendons share a hue and darken with the tension; where there is one
// such family only, the ramp from dark blue to yellow-green is used.
colour rod_ink(const rod_result *rod, int solution);

// "t1 0.98 N, t2 0.2 N"; "no tension"
void rod_label(const rod_result *rod, int solution, char *text, size_t size);

typedef enum rod_note { ROD_NOTE_BEND, ROD_NOTE_CURVATURE } rod_note;

// Up to three columns of solutions with a number each.
void rod_legend(canvas *c, const rod_result *rod, box at, rod_note note);
double rod_legend_height(const rod_result *rod); // [points]

// The size of the curvature along one solution: at both ends, smallest and where, largest.
typedef struct curvature_range {
    double base, tip, least, largest; // [1/m]
    double at;                        // arclength of the least [m]
} curvature_range;
curvature_range rod_curvature_range(const rod_result *rod, int solution);
