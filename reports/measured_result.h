// reports/measured_result.h
// The model's shapes against measured ones, and what is shown of it.
#pragma once

#include "base/dense.h"
#include "measure/measured_keys.h"

enum { MEASURED_NAME = 96, MEASURED_SOURCE = 240 };

// One measured shape, over the arclength of the unloaded rod, in the frame of its base.
typedef struct measured_line {
    char name[MEASURED_NAME], file[MEASURED_NAME];
    int solution;      // of the rod, from 0
    bool tip;          // the line ends at the tip
    bool turn_free;    // its frame is free in its turn about z: distances depend on a choice
    int better;        // the solution that it lies far nearer to, from 0; -1: none
    double better_rms; // its rms distance [m]; NAN
    shape_error error;
    int npoint;
    double *s, *sigma;  // [npoint] [m]; sigma NAN: unknown
    vec3 *p, *model;    // [npoint] [m]
    vec3 *bend;         // [npoint] turn per arclength in the model's body frame [1/m]; NAN: unknown
    double *bend_sigma; // [npoint] of each component [1/m]
} measured_line;

typedef struct measured_result {
    bool synthetic;
    char source[MEASURED_SOURCE]; // "" where not given
    int paper, arclength;         // measured_paper, shape_arclength
    double tolerance;             // 0: no verdict
    double window;                // of arclength, behind `bend` [m]
    int nline;
    measured_line *line;
} measured_result;

// Room for npoint points.
status measured_line_room(measured_line *line, int npoint);
void measured_result_free(measured_result *m);
