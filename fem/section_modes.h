// fem/section_modes.h
// Motions of a section that a body makes with little energy: what separable.h misjudges. After the
// six rigid ones the chain of Saint-Venant's (each the warping that the one before asks for when it
// changes along s), and the softest of the section itself. docs/theory.md (5.14d)
#pragma once

#include "fem/petsc_plane_door.h"
#include "fem/plane_forms.h"

typedef struct section_modes {
    int count;     // without the rigid ones
    double *value; // [3 nplane][count] rows direction nplane + node, in the section's axes;
                   // orthonormal times the root of nplane
    bool *along;   // [count] it moves along s alone, else in the plane alone
} section_modes;

// The same on every rank: each makes them for itself.
status section_modes_make(const petsc_plane_door *door, const body *b, const plane_forms *forms,
                          section_modes *out);
void section_modes_free(section_modes *m);

// The six rigid motions of a level that is held, rotations over the radius: [3 nplane][6] in the
// base's axes, about the section's origin there.
void section_rigid(const body *b, int level, double *value);
