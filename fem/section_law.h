// fem/section_law.h
// The law of the section by 3D FEM: strain energy per length of six unit wrenches. docs/theory.md
// (5.5)
#pragma once

#include "fem/segment_run.h"

// From the energy around the height z of a solved column; relative_error is not filled.
status section_law_at(const column *c, const segment_run *run, double z, beam_law *out);

// The same from the middle of a column of its own with these plane elements, clamped and rigidly
// capped, so long that its ends do not matter (32 radii). *end_effect: what K changes half way from
// there to an end, a bound of what the ends still do.
status section_law_solve(const petsc_door *door, const mesh *plane, const material *materials,
                         double *end_effect, beam_law *out);
