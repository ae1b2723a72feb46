// fem/assembly.h
// The column's stiffness matrix, element by element into the PETSc door.
#pragma once

#include "fem/petsc_door.h"
#include "fem/supports.h"

// Every rank adds what falls into its rows. The matrix is the caller's to free through the door.
status assembly_make(const petsc_door *door, const column *c, const supports *s, int rank, int size,
                     petsc_matrix **out);
