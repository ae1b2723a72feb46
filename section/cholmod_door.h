// section/cholmod_door.h
// Sparse Cholesky factors. CHOLMOD and its types stay in cholmod_door.c.
#pragma once

#include "base/status.h"

#include <stdbool.h>

// The lower triangle of a symmetric or Hermitian matrix by columns, the diagonal first, rows
// ascending.
typedef struct sparse_lower {
    int n;
    int *start;    // [n + 1]
    int *row;      // [start[n]]
    double *value; // [start[n]], or where complex [start[n]][2]; NULL for a pattern
    bool complex;  // values are pairs: real part, imaginary part
} sparse_lower;

void sparse_lower_free(sparse_lower *a);

typedef struct cholesky cholesky;

// A fill-reducing order of the pattern: permutation[new] = old, [n].
status cholesky_order(const sparse_lower *pattern, int *permutation);

// Factors once, in the matrix's own order: number the unknowns so beforehand. ERR_NUMERIC where the
// matrix is not positive definite to rounding.
status cholesky_make(const sparse_lower *a, cholesky **out);
void cholesky_free(cholesky *c);

// x = a^-1 b for nrhs columns of n values, pairs where a is complex, each `stride` values after the
// one before; they may be the same array.
status cholesky_solve(cholesky *c, int nrhs, int stride, const double *b, double *x);
