// fem/coarse.h
// The coarse space of the iterative way: section_modes at every level, solved exactly. It is a rod
// with as many freedoms as there are modes; every rank has the whole of it. docs/theory.md (5.14d)
#pragma once

#include "fem/apply.h"
#include "fem/petsc_door.h"
#include "fem/section_modes.h"

typedef struct coarse_spec {
    const petsc_door *door;
    const body *body;
    const plane_forms *forms;
    const section_modes *modes;
    apply *product; // of this rank's layers
    int rank, size;
    int first, last; // levels whose rows this rank has
    int first_layer, last_layer;
    bool clamped; // nothing moves at the base
    bool guided;  // nothing moves along s there
    bool cap;     // the tip moves rigidly
    bool drifts;  // nothing holds the base in its plane: rigid motions there are free
} coarse_spec;

typedef struct coarse coarse;

// (all) ERR_NUMERIC where supports leave a motion free.
status coarse_make(const coarse_spec *spec, coarse **out);
void coarse_free(coarse *c); // NULL is nothing

// (all) y = A^-1 P^T r: [nlevel][modes][ncol], from the fields of the levels that this rank has.
void coarse_solve(coarse *c, int ncol, const double *r, double *y);
// z += P y on the levels that this rank has.
void coarse_add(coarse *c, int ncol, const double *y, double *z);

size_t coarse_values(const coarse *c); // nlevel modes
double coarse_bytes(const coarse *c);
