// section/extremes.h
// The largest strains and stresses of each material, and where. docs/theory.md (3.22)
#pragma once

#include "section/fields.h"

typedef struct section_extreme {
    double value;
    double at[2]; // [m]
} section_extreme;

typedef struct section_extremes {
    bool used;                     // the section has some of this material
    section_extreme strain;        // the principal strain of largest magnitude, with its sign
    section_extreme von_mises;     // [Pa]
    section_extreme axial_highest; // zz stress [Pa]
    section_extreme axial_lowest;
} section_extremes;

// Over all nodes, for one wrench at the section's origin; out [nmaterial].
void section_extremes_find(const section_fields *f, const material *materials, int nmaterial,
                           const vec6 *wrench, section_extremes *out);

// The strain alone, cheaper: `largest` [nmaterial] is replaced where this wrench strains a material
// more; *replaced, where not NULL, tells which [nmaterial].
void section_largest_strain(const section_fields *f, const vec6 *wrench, section_extreme *largest,
                            bool *replaced);
