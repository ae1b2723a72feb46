// fem/petsc_inside.h
// What the modules of the PETSc door share; no file outside of it includes this.
#pragma once

#include "fem/petsc_door.h"

#include <petscmat.h>

enum { PETSC_BLOCK = 3 };

typedef struct petsc_grid petsc_grid; // of petsc_grid_door_module.c

struct petsc_matrix {
    Mat A, factor;
    petsc_grid *grid; // in place of factors; NULL: none
    int nblock, first, last;
};

// what a user can do about memory
#define PETSC_SMALLER "take fewer fem.layers, a lower fem.order or a larger fem.size_mm"

status petsc_fail(PetscErrorCode code, const char *call);

#define PETSC_TRY(call)                                                                            \
    do {                                                                                           \
        PetscErrorCode code_ = (call);                                                             \
        if (code_) {                                                                               \
            TRY(petsc_fail(code_, #call));                                                         \
        }                                                                                          \
    } while (0)

// --- petsc_door_module.c

status petsc_agree(status mine);   // petsc_door.agree
double petsc_machine_memory(void); // left in the machine, or to this process [byte]

// --- petsc_matrix_door_module.c

status petsc_matrix_make(const petsc_pattern *pattern, petsc_matrix **out);
status petsc_matrix_add(petsc_matrix *m, int n, const int *block, const double *a);
status petsc_matrix_factor(petsc_matrix *m, petsc_factors *out);
void petsc_matrix_free(petsc_matrix *m);

// --- petsc_solve_door_module.c

status petsc_matrix_solve(petsc_matrix *m, int ncol, const double *b, double *x);

// --- petsc_grid_door_module.c

status petsc_matrix_coarsen(petsc_matrix *m, const double *motions, petsc_factors *out);
status petsc_grid_solve(petsc_matrix *m, int ncol, const double *b, double *x);
int petsc_matrix_steps(const petsc_matrix *m);
void petsc_grid_free(petsc_grid *g); // NULL is nothing
