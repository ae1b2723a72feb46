// fem/section_fit.h
// Tractions weight x (rigid motion) on a section, and the weighted fit of a rigid motion: each is
// the other's conjugate. docs/theory.md (5.6), (5.2)
#pragma once

#include "base/dense.h"
#include "fem/column.h"

typedef enum fit_weight { WEIGHT_E, WEIGHT_ONE } fit_weight;

typedef struct section_fit {
    int nplane;
    double *force; // [6][nplane][3] nodal forces whose resultant at the origin is the unit wrench
                   // (n, m)
    double weight; // int w: EA [N] or the area [m^2]
    double centroid[2]; // of the weight [m]
} section_fit;

status section_fit_make(const column *c, fit_weight weight, section_fit *out);
void section_fit_free(section_fit *fit);

// Translation at the origin and rotation nearest to u [nplane][3] of one level in the weighted mean
// square.
vec6 section_fit_motion(const section_fit *fit, const double *u);
