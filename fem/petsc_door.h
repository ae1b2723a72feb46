// fem/petsc_door.h
// The door to PETSc (MPI, MUMPS): symmetric positive definite matrices of 3 x 3 blocks, factored
// once for many right-hand sides. No PETSc type passes through. Opened by door_open("petsc",
// PETSC_DOOR_SYMBOL, ...), base/door.h.
//
// Every rank must call what is marked (all); rows, values and answers are those of this rank alone.
#pragma once

#include "base/status.h"

typedef struct petsc_matrix petsc_matrix;

// Which blocks of the upper triangle this rank will hold. Rows are shared out in one run per rank,
// ascending with the rank; ranks without rows come last.
typedef struct petsc_pattern {
    int nblock;      // block rows in all
    int first, last; // this rank's: first <= row < last
    const int
        *diagonal;     // [last - first] blocks in columns row..last-1, the diagonal one among them
    const int *beyond; // [last - first] blocks in columns from last on
} petsc_pattern;

typedef struct petsc_factors {
    double norm;    // |A| of the maximum norm
    double flops;   // that the factorization took, of all ranks
    double entries; // of the factors, of all ranks
    double bytes;   // of this rank: matrix and factors
} petsc_factors;

typedef struct petsc_door {
    // Starts MPI and PETSc when nobody has yet; they end with the process. Under mpirun every rank
    // must call. A process that then exits with an error takes the others with it, unless they do
    // too. ERR_EXTERNAL conditions come as ERR_RESOURCE or ERR_BUG with the library's words.
    status (*start)(int *rank, int *size);

    double (*memory)(void); // left in the machine, or to this process [byte]

    // (all) What one rank failed at, all fail at: ends a stretch in which ranks work alone.
    status (*agree)(status mine);
    // (all) Sums and maxima over the ranks, in place, the same on all of them.
    void (*sum)(int n, double *v);
    void (*largest)(int n, double *v);
    // (all) Values to the rank before this one, and from the one after; ranks without any to send
    // or to get say 0, and the pairs must agree.
    void (*pass_down)(int nsend, const double *send, int nget, double *get);
    // (all) The same to the rank after this one, from the one before.
    void (*pass_up)(int nsend, const double *send, int nget, double *get);

    // (all)
    status (*matrix_make)(const petsc_pattern *pattern, petsc_matrix **out);

    // Adds the dense a [3n][3n], by rows, at the n block rows and columns; a negative one is left
    // out, and so is all that lies in the lower triangle or in another rank's rows.
    status (*matrix_add)(petsc_matrix *m, int n, const int *block, const double *a);

    // (all) After the last matrix_add. ERR_NUMERIC: not positive definite; ERR_RESOURCE: no memory.
    status (*matrix_factor)(petsc_matrix *m, petsc_factors *out);

    // (all) The same without factors: conjugate gradients with algebraic multigrid will solve.
    // motions [6][3 (last - first)]: the rigid ones of the whole body, zero where it is held.
    status (*matrix_coarsen)(petsc_matrix *m, const double *motions, petsc_factors *out);
    // Most iterations that a column took so.
    int (*matrix_steps)(const petsc_matrix *m);

    // (all) x = A^-1 b by the factors, or to 1e-9 without them; b, x [ncol][3 (last - first)].
    status (*matrix_solve)(petsc_matrix *m, int ncol, const double *b, double *x);

    void (*matrix_free)(petsc_matrix *m); // (all) NULL is nothing
} petsc_door;

// const petsc_door *stiffaxis_petsc_door(void)
#define PETSC_DOOR_SYMBOL "stiffaxis_petsc_door"
typedef const petsc_door *(*petsc_door_getter)(void);

// Opens the module once.
status petsc_door_open(const petsc_door **out);
