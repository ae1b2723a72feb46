// fem/petsc_door.h
// The door to PETSc (MPI, MUMPS): symmetric positive definite matrices of 3 x 3 blocks, factored
// once for many right-hand sides. No PETSc type passes through. Opened by door_open("petsc",
// PETSC_DOOR_SYMBOL, ...), base/door.h.
#pragma once

#include "base/status.h"

typedef struct petsc_matrix petsc_matrix;

// Which blocks of the upper triangle this rank will hold. Rows are shared out in one run per rank.
typedef struct petsc_pattern {
    int nblock;      // block rows in all
    int first, last; // this rank's: first <= row < last
    const int
        *diagonal;     // [last - first] blocks in columns row..last-1, the diagonal one among them
    const int *beyond; // [last - first] blocks in columns from last on
} petsc_pattern;

typedef struct petsc_door {
    // Starts MPI and PETSc when nobody has yet; they end with the process. Under mpirun every rank
    // must call. ERR_EXTERNAL conditions come as ERR_RESOURCE or ERR_BUG with the library's words.
    status (*start)(int *rank, int *size);

    status (*matrix_make)(const petsc_pattern *pattern, petsc_matrix **out);

    // Adds the dense a [3n][3n], by rows, at the n block rows and columns; a negative one is left
    // out, and so is all that lies in the lower triangle or in another rank's rows.
    status (*matrix_add)(petsc_matrix *m, int n, const int *block, const double *a);

    // After the last matrix_add. *norm: |A| of the maximum norm. ERR_NUMERIC: not positive
    // definite; ERR_RESOURCE: no memory.
    status (*matrix_factor)(petsc_matrix *m, double *norm);

    // x = A^-1 b by the factors; b, x [ncol][3 nblock], whole and equal on every rank.
    status (*matrix_solve)(petsc_matrix *m, int ncol, const double *b, double *x);

    // y = A x in extended precision; x, y [3 nblock][ncol], whole and equal on every rank.
    status (*matrix_multiply)(petsc_matrix *m, int ncol, const double *x, long double *y);

    void (*matrix_free)(petsc_matrix *m); // NULL is nothing
} petsc_door;

// const petsc_door *stiffaxis_petsc_door(void)
#define PETSC_DOOR_SYMBOL "stiffaxis_petsc_door"
typedef const petsc_door *(*petsc_door_getter)(void);
