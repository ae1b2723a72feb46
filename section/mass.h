// section/mass.h
// What follows from the section's area alone: its centre and its mass. docs/theory.md (3.23)
#pragma once

#include "base/dense.h"
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

status section_mass_of(const mesh *m, const material *materials, section_mass *out);
