// section/integrals.h
// E- and G-weighted integrals over a section, and the paper's stiffness from them. docs/theory.md
// (2.2)-(2.5)
#pragma once

#include "base/beam_law.h"
#include "base/material.h"
#include "section/mass.h"

typedef struct moments {
    double one, x, y, xx, yy, xy; // int, int x, int y, int x^2, int y^2, int x y
} moments;

// What the paper's model takes of a material: stress (zz, xz, yz) under those strains where all
// other stresses vanish, without what couples zz with the shears. docs/theory.md (2.9)
typedef struct rod_moduli {
    double E;           // of zz [Pa]
    double Gx, Gy, Gxy; // of xz, of yz, and what couples the two
    double density;     // [kg/m^3]; 0: not known
} rod_moduli;

// In the section's axes; of a polar frame in its local ones. frame NULL: the section's own.
rod_moduli rod_moduli_of(const material *m, const material_frame *frame);

// Moduli along x' = (c, s), y' = (-s, c) as those along x, y.
rod_moduli rod_moduli_turned(const rod_moduli *m, double c, double s);

typedef struct section_integrals {
    double area; // [m^2]
    moments E, Gx, Gy, Gxy;
    mass_sum mass;
    double centre[2]; // the point that x and y are taken from, in the section's frame [m]
} section_integrals;

// Adds a piece of one material, given its plain moments; grade: E(x, y) over m->E.
void integrals_add(section_integrals *sum, const moments *piece, const rod_moduli *m, double grade);

// ERR_INPUT for a section of no area.
status integrals_law(const section_integrals *i, beam_law *out);
