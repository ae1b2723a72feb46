// fem/separable.h
// The preconditioner of the iterative way: the body as a prism whose motions in the plane and along
// it do not feel each other. Modes along s make each of its problems one in the plane, solved by
// sparse factors. docs/theory.md (5.14c)
//
// Ranks have levels; planes of modes and strips of nodes are exchanged among all of them.
#pragma once

#include "fem/petsc_door.h"
#include "fem/petsc_plane_door.h"
#include "fem/plane_forms.h"

// Who has which levels, and what of them is unknown.
typedef struct separable_layout {
    int rank, size;
    const int *first; // [size + 1] levels of every rank
    bool base[2];     // level 0 is unknown: in the plane, along s
    bool tip;         // the last level is unknown
} separable_layout;

typedef struct separable separable;

// (all) For fields of up to ncol columns.
status separable_make(const petsc_plane_door *door, const body *b, const plane_forms *forms,
                      const separable_layout *layout, int ncol, separable **out);
void separable_free(separable *s); // NULL is nothing

// (all) z = its inverse times r: [own levels][direction][node][ncol] in the sections' axes, zero
// where nothing is unknown.
status separable_solve(separable *s, int ncol, const double *r, double *z);

double separable_bytes(const separable *s); // of this rank's factors
