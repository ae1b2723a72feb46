// app/calculix_files.h
// The deck that CalculiX reads (mm, N, MPa) and the displacements that it prints.
#pragma once

#include "base/dense.h"
#include "fem/level_fit.h"

#include <stdio.h>

// A body of order 2 on a plane mesh of order 2, isotropic materials, clamped at its base.
typedef struct calculix_problem {
    const body *body;
    bool cap;             // the tip is a rigid body; else `fit` says how a wrench enters
    const level_fit *fit; // of the tip, by E
    bool reduced;         // C3D20R instead of C3D20
    int nload;
    const vec6 *wrench; // [nload] about the section's origin at the tip [N, N m]
} calculix_problem;

// One linear step per load. 20-node hexahedra and 15-node prisms on the corners and the middles of
// edges of the body's elements.
status calculix_write(const calculix_problem *p, FILE *file);

// The displacements of the tip's plane nodes after each step, u [nload][nplane][3] [m]; those in
// the middle of quadrilaterals, which CalculiX does not have, by its elements' own interpolation.
// ERR_NUMERIC where a number is missing.
status calculix_read(const calculix_problem *p, FILE *file, double *u);
