// fem/level_fit.h
// Tractions weight x (rigid motion) on a section, and the weighted fit of a rigid motion: each is
// the other's conjugate. docs/theory.md (5.6), (5.2)
#pragma once

#include "base/dense.h"
#include "fem/body.h"

typedef enum level_weight {
    LEVEL_BY_E,
    LEVEL_BY_AREA
} level_weight; // E: along the rod, graded where the material is

typedef struct level_fit {
    int nplane;
    double *force; // [6][nplane][3] nodal forces whose resultant about the section's origin is the
                   // unit wrench (n, m), in the base's axes
    double weight; // int w: EA [N] or the area [m^2]
    double centroid[2]; // of the weight, in the section's own axes [m]
} level_fit;

// Of one level that is held, over the matter of the layer below it (of the first: above it).
status level_fit_make(const body *b, int level, level_weight weight, level_fit *out);
void level_fit_free(level_fit *fit);

// Translation at the section's origin and rotation nearest to u [nplane][3] of the level in the
// weighted mean square, in the base's axes.
vec6 level_fit_motion(const level_fit *fit, const double *u);
