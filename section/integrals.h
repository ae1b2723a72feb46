// section/integrals.h
// E- and G-weighted integrals over a section, and the paper's stiffness from them. docs/theory.md
// (2.2)-(2.5)
#pragma once

#include "base/beam_law.h"
#include "base/material.h"

typedef struct moments {
    double one, x, y, xx, yy, xy; // int, int x, int y, int x^2, int y^2, int x y
} moments;

typedef struct section_integrals {
    double area; // [m^2]
    moments E, G;
    double centre[2]; // the point that x and y are taken from, in the section's frame [m]
} section_integrals;

// Adds a piece of one material, given its plain moments.
void integrals_add(section_integrals *sum, const moments *piece, const material *m);

// ERR_INPUT for a section of no area.
status integrals_law(const section_integrals *i, beam_law *out);
