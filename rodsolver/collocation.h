// rodsolver/collocation.h
// Gauss collocation with three stages, order 6, on panels of the reference arclength; and rotations
// by it, docs/theory.md (4.13).
#pragma once

#include "base/dense.h"
#include "rodsolver/lie_step.h"

// Stage i lies at gauss_point[i]; integrals up to it weigh the stages by gauss_inner[i], over the
// whole panel by gauss_weight, from it to the panel's end by gauss_outer[i].
extern const double gauss_inner[GAUSS_STATIONS][GAUSS_STATIONS];
extern const double gauss_outer[GAUSS_STATIONS][GAUSS_STATIONS];

// R' = R hat(w) over a panel of length h from the rotation R, w at the three stages in the body
// frame: rotations at the stages and at the panel's end.
void collocate_rotation(double h, mat3 R, const vec3 w[GAUSS_STATIONS], mat3 stage[GAUSS_STATIONS],
                        mat3 *end);
