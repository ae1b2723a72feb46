// fem/refined_solve.h
// A x = b by the door's factors and iterative refinement, each rank with its own rows.
#pragma once

#include "fem/petsc_door.h"

#include <stddef.h>

typedef struct refined_system {
    const petsc_door *door;
    petsc_matrix *matrix; // factored
    double norm;          // of A, as matrix_factor gave it
    size_t n;             // rows of this rank
    int ncol;
    const double *b; // [ncol][n]
    // (all) r = b - A x, as accurately as may be: refinement then reaches the solution of that A to
    // the last digits, whatever the factors are of
    status (*residual)(void *self, const double *x, double *r);
    void *self;
} refined_system;

typedef struct refined_answer {
    double residual; // largest of |b - A x| / (|A| |x| + |b|) over the columns, in the maximum
                     // norm, before the refinement
    double moved;    // what the last step changed x by, over x
} refined_answer;

// (all) x [ncol][n]. ERR_NUMERIC where the residual is not small, or where a step changes x too
// much: then supports or joints leave the body all but free.
status refined_solve(const refined_system *s, double *x, refined_answer *out);
