// section/strain_along.h
// The largest strain of every material along a rod whose sections carry known wrenches.
// docs/theory.md (3.28)
#pragma once

#include "section/section.h"

typedef struct section_strain_place {
    double value; // the principal strain of largest magnitude, with its sign; 0 where there is none
                  // of the material
    double s, at[2]; // [m]
} section_strain_place;

typedef struct section_wrenches_along {
    int nsample;
    const double *s; // [nsample] [m]
    int nset;
    const vec6 *wrench; // [nset][nsample] of the section at s, in the body frame about its origin
} section_wrenches_along;

// Places whose section is another's, moved, share one solve; no more than
// SECTION_STRAIN_SOLVES are made, spread over the samples, and places that none of them serves are
// left out.
enum { SECTION_STRAIN_SOLVES = 9 };

// The sections solved once for all wrenches to come: what a wrench strains is linear in it.
typedef struct strains_along strains_along;

// Strains at nsample places s [m]. What c and law are about is not kept.
status strains_along_make(const section_case *c, const material *materials, const law_along *law,
                          int nsample, const double *s, strains_along **out);
void strains_along_free(strains_along *k);

// wrench [nsample], out [nmaterial]
status strains_along_at(const strains_along *k, const vec6 *wrench, section_strain_place *out);

// The same for the nset of `wrenches`.
status section_strain_along(const section_case *c, const material *materials, const law_along *law,
                            const section_wrenches_along *wrenches, section_strain_place *out);
