// The linear system of one step of a tube's fit: measure/tube_fit.c uses it.
#pragma once

#include "measure/tube_inside.h"

typedef struct tube_normal {
    int n;               // 3 ncoef + 2: coefficients, radius, its taper
    double *A, *g;       // sum of w J^T J, of w J^T residual
    double *rough;       // [ncoef]^2 integral of third derivatives' products
    double *along;       // [n]^2 steps along the line, which the points do not decide
    double *work, *step; // [n]^2, [n]
    double sum, square;  // of weights, of weighted squares of residuals
} tube_normal;

status tube_normal_make(const tube_curve *c, tube_normal *out);
void tube_normal_free(tube_normal *n);
void tube_normal_fill(const tube_fit *f, tube_normal *n);
// n->step for f->smoothing; where `invert`, n->work becomes the inverse
status tube_normal_step(const tube_fit *f, tube_normal *n, bool invert);
// f->smoothing by cross-validation
status tube_normal_choose(tube_fit *f, tube_normal *n);
status tube_normal_covariance(tube_fit *f, tube_normal *n, double reach);
