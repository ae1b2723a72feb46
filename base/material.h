// base/material.h
// Linear elastic materials of a case: isotropic, orthotropic or anisotropic, uniform or graded.
//
// Own axes 1 (fibre), 2, 3; a material_frame says how they lie in the section. Strains and stresses
// in the section are ordered xx yy zz yz xz xy with engineering shear strains.
#pragma once

#include "base/dense.h"
#include "base/field.h"
#include "base/field_table.h"
#include "base/key.h"
#include "base/material_frame.h"
#include "base/status.h"

// what a modulus may be [Pa]
#define MATERIAL_SMALLEST_MODULUS 1e-3
#define MATERIAL_LARGEST_MODULUS 1e16

typedef enum material_kind {
    MATERIAL_ISOTROPIC,
    MATERIAL_ORTHOTROPIC, // nine constants
    MATERIAL_ANISOTROPIC, // a 6x6
} material_kind;

typedef struct material {
    mark at;          // its place in the case file
    const char *name; // owned by the case
    // isotropic as it stands; of another kind what material_bind finds: E along the rod of an
    // element without a frame of its own (1 / S_zz) and the mean of its two Poisson's ratios
    double E; // Young's modulus [Pa], > 0; of a graded material its value at x = y = s = 0, or
              // where that is not positive 1
    double nu;
    double linear_strain; // largest strain at which the material stays close to linear; 0 = not
                          // known
    double density;       // [kg/m^3]; 0: not given
    place_field modulus;  // E as the case gives it; graded over the place [Pa]
    field_table table;    // the same by a table
    double fibre_angle, plane_angle; // of the material's axes in every frame [rad]
    int kind;                        // material_kind, set by material_bind
    double E1, E2, E3, G12, G13, G23, nu12, nu13,
        nu23;           // orthotropic [Pa, -]; nu_ij = -eps_j / eps_i
    key_rows stiffness; // anisotropic: [6][6] in own axes, order 11 22 33 23 13 12 [Pa]
    mat6 in_frame; // Q along a frame's axes, order 11 22 33 23 13 12, own angles done [Pa]; set by
                   // material_bind where the kind is not isotropic
} material;

extern const key_table material_keys; // one entry of `materials`

// Finds the kind, E, nu and in_frame; once, where the struct is to stay. ERR_INPUT, with the
// material's place, where the elastic constants are not positive definite: the message names the
// inequality that they break.
status material_bind(material *m);

// The same material at arclength s: what is graded along the rod is frozen there.
material material_at(const material *m, double s);

static inline bool material_is_graded(const material *m) // over the section
{
    return m->modulus.at && m->modulus.across;
}

static inline bool material_varies(const material *m) // along the rod
{
    return m->modulus.at && m->modulus.along;
}

// E(x, y) / E of a graded material, else 1; may be <= 0 where the case's expression is.
double material_grade(const material *m, double x, double y);

// The same; ERR_INPUT, with the material's place in the case, where E is not a modulus there.
status material_check_grade(const material *m, double x, double y, double *grade);

double material_shear_modulus(const material *m); // G = E / (2 (1 + nu)) [Pa]; isotropic

// Q in the section's axes: stress = Q strain [Pa], at the modulus E. `frame` NULL: the section's
// own. A polar frame is taken at (x, y).
mat6 material_stiffness_in(const material *m, const material_frame *frame, double x, double y);

// The same without a frame.
mat6 material_stiffness(const material *m);

// The same along axes that material_frame_axes_at gave.
mat6 material_stiffness_along(const material *m, mat3 axes);
