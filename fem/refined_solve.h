// fem/refined_solve.h
// A x = b by the door's factors and one step of iterative refinement.
#pragma once

#include "fem/petsc_door.h"

#include <stddef.h>

// norm: of A, as matrix_factor gave it. b, x [ncol][n], n = 3 blocks, whole and equal on every
// rank. *relative: largest of |b - A x| / (|A| |x| + |b|) over the columns, in the maximum norm,
// before the refinement. ERR_NUMERIC where that is not small.
status refined_solve(const petsc_door *door, petsc_matrix *matrix, double norm, size_t n, int ncol,
                     const double *b, double *x, double *relative);
