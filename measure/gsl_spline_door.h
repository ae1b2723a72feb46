// What the centreline of a tube takes from the GNU Scientific Library: B-splines, and Cholesky's
// way through symmetric systems. Part of the module of measure/gsl_door.h.
#pragma once

#include "base/status.h"

#include <stdbool.h>

typedef struct gsl_spline_door {
    // taylor [npiece][order][order]: on each of npiece equal pieces of [0, length], those `order`
    // B-splines that are not zero there (the first one has the piece's number) as coefficients of
    // the powers of (u - the piece's middle)
    status (*pieces)(int order, int npiece, double length, double *taylor);

    // a [n][n] symmetric positive definite; b [n]: the right side in, the solution out; where
    // `invert`, a becomes its inverse, else it is spent. ERR_NUMERIC where it is not definite.
    status (*solve)(int n, double *a, double *b, bool invert);
} gsl_spline_door;

status gsl_spline_door_open(const gsl_spline_door **out);

#define GSL_SPLINE_DOOR_SYMBOL "stiffaxis_gsl_spline_door"
typedef const gsl_spline_door *(*gsl_spline_door_getter)(void);
const gsl_spline_door *stiffaxis_gsl_spline_door(void);
