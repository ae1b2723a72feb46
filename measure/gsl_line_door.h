// measure/gsl_line_door.h
// Linear least squares of the GNU Scientific Library, a part of the module of measure/gsl_door.h.
#pragma once

#include "base/status.h"

typedef struct line_problem {
    int n, p;
    const double *design; // [n][p]
    const double *y;      // [n]
} line_problem;

typedef struct gsl_line_door {
    // beta [p] with least |y - design beta|; covariance [p][p] (design^T design)^-1. ERR_NUMERIC
    // where there are fewer points than coefficients, or they cannot be told apart.
    status (*fit)(const line_problem *l, double *beta, double *covariance);
} gsl_line_door;

status gsl_line_door_open(const gsl_line_door **out);

#define GSL_LINE_DOOR_SYMBOL "stiffaxis_gsl_line_door"
typedef const gsl_line_door *(*gsl_line_door_getter)(void);
const gsl_line_door *stiffaxis_gsl_line_door(void);
