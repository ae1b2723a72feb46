// fem/petsc_plane_door.h
// What the iterative way needs of PETSc beside petsc_door.h: sparse factors that one rank has for
// itself (CHOLMOD), and values that all ranks exchange. In the same module; petsc_door.start comes
// first.
#pragma once

#include "base/status.h"

typedef struct petsc_plane petsc_plane;

typedef struct petsc_plane_door {
    // Factors of a symmetric positive definite matrix [n][n]; its upper triangle by rows, ascending
    // columns. ERR_NUMERIC: not positive definite; ERR_RESOURCE: no memory.
    status (*factor)(int n, const int *start, const int *column, const double *value,
                     petsc_plane **out);
    // x = A^-1 b; b, x [ncol][n].
    status (*solve)(petsc_plane *p, int ncol, const double *b, double *x);
    double (*bytes)(const petsc_plane *p); // of the factors, where known
    void (*free)(petsc_plane *p);          // NULL is nothing

    // (all) Values to every rank and from every rank, one run after the other by rank: counts
    // [size].
    status (*exchange)(const int *nsend, const double *send, const int *nget, double *get);
} petsc_plane_door;

// const petsc_plane_door *stiffaxis_petsc_plane_door(void)
#define PETSC_PLANE_DOOR_SYMBOL "stiffaxis_petsc_plane_door"
typedef const petsc_plane_door *(*petsc_plane_door_getter)(void);

status petsc_plane_door_open(const petsc_plane_door **out);
