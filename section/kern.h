// section/kern.h
// The kern of a section: where an axial compressive force leaves no point of it in tension.
// docs/theory.md (3.24)
#pragma once

#include "base/beam_law.h"
#include "base/mesh.h"

// Corners, counter-clockwise, *kern [*count][2] the caller's to free [m]. *count 0 where no such
// place exists.
status section_kern(const mesh *m, const beam_law *law, int *count, double (**kern)[2]);
