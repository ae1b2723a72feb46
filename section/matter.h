// section/matter.h
// What the elements of a plane mesh are made of: their material matrices in the section's axes,
// each pair of material and frame worked out once.
#pragma once

#include "base/material.h"
#include "section/plane.h"

#include <stdbool.h>

enum { XX, YY, ZZ, YZ, XZ, XY };

typedef struct matter_law {
    int material, frame; // frame -1: the section's own axes
    int next;            // the next law of the same frame, -1 at the end
    bool graded;         // the modulus is given over the place
    bool polar;          // the axes turn with the place: Q is only one of many
    mat6 Q;              // in units of matter.modulus
} matter_law;

typedef struct matter {
    const mesh *mesh;
    const material *materials;
    double modulus; // the largest on the diagonals of the laws' Q [Pa]
    bool coupled;   // some Q couples xx, yy, zz, xy with yz, xz
    int nlaw, room;
    matter_law *law;
    int *of[MESH_MAX_BLOCKS]; // [nelem] law of each element
} matter;

// The matter of one element at its quadrature points.
typedef struct matter_element {
    const matter_law *law;
    double weight[ELEMENT_MAX_PLANE_POINTS]; // dA times the grade of the modulus
    mat6 Q;                                  // at the point asked for last where the law is polar
} matter_element;

// The mesh and the materials must outlive it.
status matter_make(const mesh *m, const material *materials, matter *out);
void matter_free(matter *m);

// ERR_INPUT, at the material's place, where a graded modulus is not positive.
status matter_at(const matter *m, const plane *p, const plane_element *e, matter_element *out);

// Q at point q; stands until the next call.
const mat6 *matter_stiffness(const matter *m, const plane *p, const plane_element *e, int q,
                             matter_element *at);
