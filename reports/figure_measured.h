// reports/figure_measured.h
// What the pictures of measured shapes share.
#pragma once

#include "reports/figure_kit.h"
#include "reports/result.h"

colour measured_ink(const run_result *r, int line);

// Title and, in plain sight, what the data is.
void measured_heading(canvas *c, const run_result *r, const char *title, double side, double width);

// One entry per shape with its errors, in columns.
void measured_legend(canvas *c, const run_result *r, box at);
double measured_legend_height(const run_result *r); // [points]

// A place of a solution in the frame of its base [mm].
vec3 measured_model_mm(const run_result *r, int solution, int point);

// reports/figure_measured_along.c
status figure_measured_along(const run_result *r, const char *dir);
