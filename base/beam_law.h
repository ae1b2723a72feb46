// base/beam_law.h
// The law of a beam: how one cross section answers shear, stretch, bending and twist. section and
// fem end in one, rodsolver begins with one: that is all they share.
//
//   W = K e    e = xi - xi* = (gamma_x, gamma_y, eps, kappa_x, kappa_y, tau)    [- x 3, 1/m x 3]
//              W = (n_x, n_y, n_z, m_x, m_y, m_z)                               [N x 3, N m x 3]
//
// x and y lie in the section, z along the rod. Moments are taken about the geometric centre (the
// case's origin).
#pragma once

#include "base/dense.h"
#include "base/status.h"

enum { NX, NY, NZ, MX, MY, MZ };

typedef struct beam_law {
    mat6 K;                // symmetric positive definite [N, N m, N m^2]
    double area;           // [m^2]
    double mass;           // per length [kg/m]; 0 where no density is known
    double mass_centre[2]; // [m]
    double relative_error; // the largest of
    mat6 entry_error;      // estimates of |K - K_exact|_ij / sqrt(K_ii K_jj)
} beam_law;

// What follows from K alone, docs/theory.md section 2. Axial and bending constants are those of a
// section that is free to shear and twist: the 3x3 block (n_z, m_x, m_y) of the compliance,
// inverted.
typedef struct beam_centres {
    double EA;                  // [N]
    double stiffness_centre[2]; // where an axial force makes no curvature [m]
    double EI_centre[3];    // EIxx = int E y^2, EIyy = int E x^2, EIxy = int E x y about it [N m^2]
    double EI[2];           // about x', about y' [N m^2]
    double principal_angle; // of x' from x, in (-pi/2, pi/2] [rad]
    bool isotropic;         // no preferred axes: principal_angle is 0 by convention
    double GJ;              // 1 / F[5][5] [N m^2]
    double shear_centre[2]; // where a transverse force makes no twist [m]
} beam_centres;

// Relative difference of the two moments below which a section has no preferred axes: the rounding
// of K and the mesh's own asymmetry stay below it.
#define BEAM_LAW_ISOTROPIC 1e-7

// principal_angle: the axis with the larger int E x'^2, so EI[1] >= EI[0]. ERR_NUMERIC where K is
// not positive definite.
status beam_law_centres(const beam_law *law, beam_centres *out);

// As beam_law_centres, with x' the principal axis nearest to `near` (a declared symmetry axis, or
// the last station's). principal_angle is then not reduced to (-pi/2, pi/2]: it stays within
// pi/4 of `near`, and is `near` where isotropic.
status beam_law_centres_near(const beam_law *law, double near, beam_centres *out);

// The block (n_z, m_x, m_y) of the compliance F, inverted: EA, ESx, ... of a section free to shear
// and twist,
//   [[EA, ESx, -ESy], [ESx, EIxx, -EIxy], [-ESy, -EIxy, EIyy]] with ESx = int E y, ESy = int E x
// false when F is not positive definite.
bool beam_law_axial_bending(const mat6 *F, mat3 *out);

// The same section seen from a frame at (x, y), turned by angle: K_h = Ad(T)^T K_g Ad(T), T =
// (R_z(angle), (x, y, 0)).
mat6 beam_law_move(mat6 K, double x, double y, double angle);

// The same estimate for every entry.
void beam_law_set_error(beam_law *law, double relative_error);

// The law seen from a frame turned by angle: K as by beam_law_move, and the errors, in SI, as |R| E
// |R|^T, which no turn of an error that is within E exceeds.
beam_law beam_law_turn(beam_law law, double angle);

// ERR_NUMERIC where K is not finite, not symmetric to 1e-9 of sqrt(K_ii K_jj), or not positive
// definite.
status beam_law_check(const beam_law *law);
