// fem/brick_law.h
// What an element of a body is made of.
#pragma once

#include "fem/body.h"

typedef struct brick_law {
    const material *m;
    bool isotropic;
    bool framed; // else along the section's own axes
    material_frame frame;
    double lambda, mu; // isotropic, at m->E [Pa]
} brick_law;

// Of plane element e of a block at s, of a material that is not -1.
status brick_law_at(const body *b, int block, int e, int material, double s, brick_law *out);

static inline bool brick_law_is_polar(const brick_law *law)
{
    return law->framed && law->frame.polar;
}

// Factor on Q at (x, y) of the section at s. ERR_INPUT where the modulus there is none.
status brick_grade(const brick_law *law, double x, double y, double s, double *grade);

// Q in the section's axes at (x, y), without the grade.
mat6 brick_section_stiffness(const brick_law *law, double x, double y);

// Modulus along the rod, 1 / S_zz, without the grade: the same wherever a polar frame is looked at.
double brick_modulus_along(const brick_law *law);
