// measure/shares.h
// What random samples say: the spread of a quantity, and which parameter it comes from.
// docs/theory.md (9.58)
#pragma once

#include "base/status.h"

// Of one quantity over all samples, in its own unit.
typedef struct sample_spread {
    double mean, deviation;   // of the samples, n - 1
    double low, median, high; // 5, 50 and 95 % quantiles
    double rest; // share of the variance that the sum of functions of one parameter each leaves
} sample_spread;

enum { SHARES_MOST_DEGREE = 3, SHARES_MOST_PARAMETERS = 40 };

// Of the polynomials by which the variance is shared out: as high as the samples can tell, 0 where
// they are too few for any.
int shares_degree(int nsample, int nparameter);

// y [n] at independent parameters x [n][p] of the order of 1, as a sum of polynomials of one
// parameter each, by least squares. share [p]: the part of y's variance in that parameter's own
// polynomial (first-order indices of Sobol, as far as polynomials of this degree go); out->rest the
// part that is in none. NAN where the samples are too few. y is sorted on return.
status shares_of(int n, int p, const double *x, double *y, int degree, double *share,
                 sample_spread *out);
