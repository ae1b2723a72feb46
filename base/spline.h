// base/spline.h
// Plane curves (x(s), y(s)) as splines: through points, or by least squares with few knots.
#pragma once

#include "base/status.h"

enum { SPLINE_MAX_DEGREE = 7 };

// In B-splines; the ends are knots of full multiplicity. Derivatives below the degree are
// continuous.
typedef struct spline {
    int degree, ncoef; // ncoef - degree pieces
    double *knot;      // [ncoef + degree + 1], ascending
    double *coef;      // [ncoef][2]
} spline;

void spline_free(spline *c);

// The curve and its slope at s, both [2]; beyond the ends the outermost pieces go on.
void spline_at(const spline *c, double s, double *value, double *slope);

// Least squares over n points, rows (s, x, y) of `point` with s ascending, by npiece pieces that
// hold equally many points each. degree + npiece = n gives the curve through the points, without
// knots at the first and last (degree - 1) / 2 inner ones. *rms: the root of the mean squared
// distance that remains. ERR_NUMERIC where points are so unevenly spaced that rounding takes over.
status spline_fit(int n, const double *point, int degree, int npiece, double *rms, spline *out);
