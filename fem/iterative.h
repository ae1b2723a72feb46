// fem/iterative.h
// What the files of the iterative way share. docs/theory.md (5.14)
//
// A field of this way is [own levels][direction][plane node][column]. Nodes of a rigid cap keep
// their own entries: displacements are those of a rigid motion, and of forces only the resultant
// counts. At nodes that are held, displacements are zero and forces mean nothing.
#pragma once

#include "fem/apply.h"
#include "fem/coarse.h"
#include "fem/level_loads.h"
#include "fem/separable.h"
#include "fem/way.h"

typedef struct iterative {
    const petsc_door *door;
    const petsc_plane_door *plane_door;
    const segment_problem *p;
    level_share share;
    bool clamped, guided, cap;
    int ncol;
    size_t block, own; // values of a level, of this rank's own levels
    int *level;        // [size + 1] first levels of all ranks
    plane_forms forms;
    section_modes modes;
    apply *product;
    separable *separable;
    coarse *coarse;
    double *b, *x;         // [own + a level]: right-hand sides, solutions
    double *r, *z, *d, *q; // [own + a level] residuals, corrections, directions, products
    double *turned;        // [own] in the sections' axes
    double *y;             // of the coarse space
    double *above;         // [level] what the rank above sends
    double norm;           // largest |K u| / |u| met: a lower bound of |K|
    int iterations;
    double residual;
} iterative;

// Whether it goes without a matrix: layers all alike, held at the base alone. Else the matrix is
// made, and algebraic multigrid takes the place of what follows (direct.h).
bool iterative_is_plain(const segment_problem *p);

// (all) f = K u of this rank's own levels; u and f have room for a level more.
status iterative_product(iterative *w, double *u, double *f);

// (all) Conjugate gradients for all columns side by side, from b into x. ERR_NUMERIC with the
// iterations and the residual where they stagnate.
status iterative_solve(iterative *w, const way_wants *wants);

// (all) Largest entry of every column at what is unknown, a cap's as its resultant: [ncol].
status iterative_largest(iterative *w, const double *f, bool forces, double *most);
