// base/material.h
// Linear elastic materials of a case.
#pragma once

#include "base/dense.h"
#include "base/key.h"
#include "base/status.h"

typedef struct material {
    mark at;          // its place in the case file
    const char *name; // owned by the case
    double E;         // Young's modulus [Pa], > 0
    double nu;        // Poisson's ratio, -1 < nu < 0.5
    double
        linear_strain; // largest strain at which the material stays close to linear; 0 = not known
} material;

extern const key_table material_keys; // one entry of `materials`

double material_shear_modulus(const material *m); // G = E / (2 (1 + nu)) [Pa]

// Q: stress = Q strain, order xx yy zz yz xz xy with engineering shear strains [Pa].
mat6 material_stiffness(const material *m);
