// measure/gsl_door.h
// What is taken from the GNU Scientific Library: least squares, quantiles, random numbers. Each
// part is a file measure/gsl_*_door_module.c of one module that is opened when first needed.
#pragma once

#include "base/status.h"

#include <stdbool.h>
#include <stddef.h>

typedef struct least_squares {
    int nresidual, nparameter;
    // r [nresidual], in units of standard deviations, at x [nparameter]; jacobian
    // [nresidual][nparameter], NULL where not wanted. What fails ends the search with that status.
    status (*residuals)(void *context, const double *x, double *r, double *jacobian);
    void *context;
    double step_tolerance; // relative change of x at which the search ends
    int most_steps;
} least_squares;

typedef struct least_squares_answer {
    int steps;
    double cost;        // |r|^2 at x
    bool short_of_it;   // ERR_NUMERIC: x is the best place so far, and not there yet
    double *covariance; // [nparameter][nparameter] (J^T J)^-1, the caller's; may be NULL
} least_squares_answer;

// gsl_fit_door_module.c: nonlinear least squares, a trust region with Levenberg and Marquardt's
// steps.
typedef struct gsl_fit_door {
    // x [nparameter]: the start in, the answer out. ERR_NUMERIC where it does not converge or the
    // parameters cannot be told apart.
    status (*least_squares)(const least_squares *problem, double *x, least_squares_answer *answer);
    // Of a symmetric matrix [n][n]: values ascending [n], vectors as columns [n][n].
    status (*eigen)(int n, const double *a, double *value, double *vector);
} gsl_fit_door;

typedef struct gsl_random gsl_random; // Mersenne twister: the same numbers for the same seed

// gsl_random_door_module.c: random numbers and distributions.
typedef struct gsl_random_door {
    status (*make)(unsigned long seed, gsl_random **out);
    void (*free)(gsl_random *g);
    double (*uniform)(gsl_random *g); // in [0, 1)
    double (*normal)(gsl_random *g);  // mean 0, deviation 1
    // t with P(|T| <= t) = share at that many degrees of freedom (0.95: the two-sided 95 %
    // interval)
    double (*student)(double share, double freedom);
} gsl_random_door;

// gsl_linear_door_module.c: linear least squares, order and quantiles.
typedef struct gsl_linear_door {
    // x [p] so that |A x - b|^2 is least, A [n][p], n >= p; by singular values, so that columns
    // that say the same share; cost: what is left of |b - A x|^2.
    status (*least_squares)(int n, int p, const double *A, const double *b, double *x,
                            double *cost);
    void (*sort)(int n, double *y); // ascending
    double (*quantile)(int n, const double *sorted, double share);
} gsl_linear_door;

status gsl_fit_door_open(const gsl_fit_door **out);
status gsl_linear_door_open(const gsl_linear_door **out);
status gsl_random_door_open(const gsl_random_door **out);

#define GSL_FIT_DOOR_SYMBOL "stiffaxis_gsl_fit_door"
typedef const gsl_fit_door *(*gsl_fit_door_getter)(void);
const gsl_fit_door *stiffaxis_gsl_fit_door(void);

#define GSL_RANDOM_DOOR_SYMBOL "stiffaxis_gsl_random_door"
typedef const gsl_random_door *(*gsl_random_door_getter)(void);
const gsl_random_door *stiffaxis_gsl_random_door(void);

#define GSL_LINEAR_DOOR_SYMBOL "stiffaxis_gsl_linear_door"
typedef const gsl_linear_door *(*gsl_linear_door_getter)(void);
const gsl_linear_door *stiffaxis_gsl_linear_door(void);
