// fem/direct_matrix.h
// The stiffness matrix of a segment_problem, element by element into the PETSc door.
#pragma once

#include "fem/petsc_door.h"
#include "fem/unknowns.h"

typedef struct direct_matrix {
    petsc_matrix *matrix; // the caller's to free through the door
    // of holds that move: their nodes' forces on this rank's rows [last - first][3], and the work
    // of the held directions on themselves, of this rank's layers; NULL and 0 where none does
    double *moved;
    double held_work;
} direct_matrix;

// (all) Every rank adds what falls into its rows.
status direct_matrix_make(const petsc_door *door, const segment_problem *p, const unknowns *u,
                          direct_matrix *out);
