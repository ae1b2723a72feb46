// section/mass.h
// What follows from the section's area alone: its centre and its mass. docs/theory.md (3.23)
#pragma once

#include "base/beam_law.h"
#include "base/material.h"
#include "base/mesh.h"

typedef struct section_mass {
    double centre[2];      // of the area [m]
    bool known;            // every material of the section has a density
    double mass;           // per length [kg/m]
    double mass_centre[2]; // [m]
    mat6 matrix; // momentum = matrix times velocity (v, omega) about the section's origin, order
                 // and reference of the wrench [kg/m, kg, kg m]
} section_mass;

// Mass per length and its first moments about some centre, piece by piece.
typedef struct mass_sum {
    bool unknown;     // a piece had no density
    double one, x, y; // [kg/m, kg, kg]
} mass_sum;

// A piece with its area and the area's first moments.
void mass_add(mass_sum *sum, double density, double area, double x, double y);

// law->mass and its centre, given the centre of the sums; both stay 0 where the mass is not known.
void mass_into_law(const mass_sum *sum, const double centre[2], beam_law *law);

status section_mass_of(const mesh *m, const material *materials, section_mass *out);
