// section/warping.h
// The integrals of docs/theory.md section 3, in scaled units: lengths of plane.length, stresses of
// the largest modulus. Strains and stresses are ordered xx yy zz yz xz xy, generalized strains and
// wrenches as in base/beam_law.h.
#pragma once

#include "base/material.h"
#include "section/plane.h"
#include "section/stiffness.h"

typedef struct warping_problem {
    plane plane;
    const material *materials;
    double modulus; // the largest E among the elements [Pa]
    double area;    // scaled
    stiffness E;    // pinned
    stiffness_pins pins;
    double *R; // [6][3 nnode], zero at the pins
    mat6 A;
} warping_problem;

// E, R and A of (3.1). The mesh must outlive the problem.
status warping_problem_make(const mesh *m, const material *materials, warping_problem *out);
void warping_problem_free(warping_problem *p);

// The right-hand sides of (3.4) for the n_x and n_y columns, element by element: `right` [2][3
// nnode] = (C^T - C) w' + L psi', zero at the pins, and `moved` = L^T w' [6][2]. dw is nodal,
// [nnode][3][2]; dpsi holds both columns, [6][2].
status warping_second_sides(warping_problem *p, const double *dw, double dpsi[6][2], double *right,
                            double moved[6][2]);

// Strain energy (3.5) and resultants int (SZ)^T stress of six fields, column by column. w and dw
// are nodal, [nnode][3][6].
status warping_energy(warping_problem *p, const double *w, const double *dw, const mat6 *psi,
                      mat6 *F, mat6 *resultant);
