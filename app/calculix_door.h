// app/calculix_door.h
// CalculiX as a child process: an outside finite element program that solves a segment on a mesh of
// ours. Nothing of it is linked; files are exchanged in a private directory that is removed again.
#pragma once

#include "base/dense.h"
#include "fem/body.h"

#include <stdbool.h>
#include <stddef.h>

// Path of the program; false where it is not installed.
bool calculix_find(char *path, size_t size);

// "2.20"; ERR_RESOURCE where it cannot be run.
status calculix_version(char *text, size_t size);

typedef struct calculix_ask {
    const body *body; // clamped at its base; of order 2 on a plane mesh of order 2; isotropic
    bool cap;         // rigid tip; else E-proportional traction
    bool reduced;     // integration: C3D20R instead of C3D20
    int nload;
    const vec6 *wrench; // [nload] about the section's origin at the tip [N, N m]
} calculix_ask;

// E-weighted motions of the tip [nload], about the section's origin there, by its 20-node
// hexahedra and 15-node prisms and its direct solver (SPOOLES). CPU time of the child [s], may be
// NULL. ERR_INPUT: such a body it does not take; ERR_RESOURCE: not installed, out of time;
// ERR_NUMERIC: no result; ERR_INTERRUPTED.
status calculix_tip(const calculix_ask *ask, vec6 *motion, double *cpu_seconds);
