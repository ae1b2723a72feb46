// fem/direct_matrix.h
// The stiffness matrix of a segment_problem, element by element into the PETSc door.
#pragma once

#include "fem/petsc_door.h"
#include "fem/unknowns.h"

// (all) Every rank adds what falls into its rows. The matrix is the caller's to free through the
// door.
status direct_matrix_make(const petsc_door *door, const segment_problem *p, const unknowns *u,
                          petsc_matrix **out);
