// section/warping.h
// The integrals of docs/theory.md section 3, in scaled units: lengths of plane.length, stresses of
// matter.modulus. Strains and stresses are ordered xx yy zz yz xz xy, generalized strains and
// wrenches as in base/beam_law.h.
#pragma once

#include "section/mass.h"
#include "section/matter.h"
#include "section/plane.h"
#include "section/stiffness.h"

// psi_nx = psi_ny = 0 holds the tilts, so that four generalized strains remain: n_z and the
// moments.
enum { KEPT = 4, FIRST_KEPT = 2 };

typedef struct warping_problem {
    plane plane;
    matter matter;
    double rate;   // at which the pattern turns, scaled
    double area;   // scaled
    mass_sum mass; // the same, about plane.centre
    stiffness E;   // pinned
    stiffness_pins pins;
    double *R;    // [KEPT][3 nnode], zero at the pins
    double *wave; // [KEPT][3 nnode][2] R - i k L; NULL where nothing turns
    mat6 A;
} warping_problem;

// E, R and A of (3.1), for a pattern that turns at `rate` [rad/m]: with the turning derivative
// (3.9), and with P and R - i k L of (3.12). The mesh must outlive the problem.
status warping_problem_make(const mesh *m, const material *materials, double rate,
                            warping_problem *out);
void warping_problem_free(warping_problem *p);

// The right-hand sides of (3.14) for w + i w* and psi + i psi* given as pairs, w [nnode][3][2] and
// psi [6][2]: `right` [3 nnode][2] = -((C - C^T) w - 2 i k M w - L psi), zero at the pins, and
// `moved` [6][2] = L^T w. Where nothing turns the two of a pair are independent, and these are
// (3.4).
status warping_second_sides(warping_problem *p, const double *w, double psi[6][2], double *right,
                            double moved[6][2]);

// Strain energy (3.5) and resultants int (SZ)^T stress of six fields, column by column, with w' = w
// T_k. w is nodal, [nnode][3][6].
status warping_energy(warping_problem *p, const double *w, const mat6 *psi, mat6 *F,
                      mat6 *resultant);

// T_k of (3.9): theta' = T_k theta, scaled
mat6 warping_transport(double rate);
