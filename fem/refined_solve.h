// fem/refined_solve.h
// A x = b by the door's factors and iterative refinement, each rank with its own rows.
#pragma once

#include "fem/petsc_door.h"

#include <stddef.h>

// norm: of A, as matrix_factor gave it. b, x [ncol][n], n of this rank. *relative: largest of
// |b - A x| / (|A| |x| + |b|) over the columns, in the maximum norm, before the refinement.
// ERR_NUMERIC where that is not small, or where a step of refinement changes x too much: then
// supports or joints leave the body all but free.
status refined_solve(const petsc_door *door, petsc_matrix *matrix, double norm, size_t n, int ncol,
                     const double *b, double *x, double *relative);
