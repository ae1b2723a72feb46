// base/beam_law.c
#include "base/beam_law.h"

#include "base/se3.h"

#include <math.h>

static const double half_pi = 1.57079632679489661923;

// rounding of a solver's K stays below this part of sqrt(K_ii K_jj)
static const double symmetry_tolerance = 1e-9;

bool beam_law_axial_bending(const mat6 *F, mat3 *out)
{
    // inside a unit matrix, so that the scaled 6x6 routine serves
    mat6 padded = mat6_identity(), inverse;
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            padded.a[i][j] = F->a[NZ + i][NZ + j];
        }
    }
    if (!mat6_inverse_spd(padded, &inverse)) {
        return false;
    }
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            out->a[i][j] = inverse.a[i][j];
        }
    }
    return true;
}

// everything but the principal axes, docs/theory.md (2.7)
static status centres_without_axes(const beam_law *law, beam_centres *c)
{
    mat6 F;
    mat3 B;
    if (!mat6_inverse_spd(law->K, &F) || !beam_law_axial_bending(&F, &B)) {
        return status_fail(ERR_NUMERIC,
                           "section stiffness: the 6x6 matrix is not positive definite");
    }
    const double EA = B.a[0][0], x = -B.a[0][2] / EA, y = B.a[0][1] / EA;
    *c = (beam_centres){
        .EA = EA,
        .stiffness_centre = {x, y},
        .EI_centre = {B.a[1][1] - EA * y * y, B.a[2][2] - EA * x * x, -B.a[1][2] - EA * x * y},
        .GJ = 1 / F.a[MZ][MZ],
        .shear_centre = {-F.a[MZ][NY] / F.a[MZ][MZ], F.a[MZ][NX] / F.a[MZ][MZ]},
    };
    const double difference = hypot(c->EI_centre[1] - c->EI_centre[0], 2 * c->EI_centre[2]);
    c->isotropic = difference <= BEAM_LAW_ISOTROPIC * (c->EI_centre[0] + c->EI_centre[1]) / 2;
    return OK;
}

// docs/theory.md (2.4): the axis of the largest int E x'^2
static double largest_axis(const beam_centres *c)
{
    return atan2(2 * c->EI_centre[2], c->EI_centre[1] - c->EI_centre[0]) / 2;
}

static void moments_along(beam_centres *c, double angle)
{
    const double Ix = c->EI_centre[0], Iy = c->EI_centre[1], Ixy = c->EI_centre[2];
    const double mean = (Ix + Iy) / 2;
    const double part = (Iy - Ix) / 2 * cos(2 * angle) + Ixy * sin(2 * angle);
    c->principal_angle = angle;
    c->EI[0] = mean - part;
    c->EI[1] = mean + part;
}

status beam_law_centres(const beam_law *law, beam_centres *out)
{
    status st = OK;
    beam_centres c = {0};
    TRY(centres_without_axes(law, &c));
    double angle = c.isotropic ? 0 : largest_axis(&c);
    // atan2 gives -pi for a negative zero
    angle = angle <= -half_pi ? half_pi : angle;
    moments_along(&c, angle);
    *out = c;

done:
    return st;
}

status beam_law_centres_near(const beam_law *law, double near, beam_centres *out)
{
    status st = OK;
    beam_centres c = {0};
    TRY(centres_without_axes(law, &c));
    double angle = near;
    if (!c.isotropic) {
        const double axis = largest_axis(&c);
        angle = axis + half_pi * round((near - axis) / half_pi);
    }
    moments_along(&c, angle);
    *out = c;

done:
    return st;
}

mat6 beam_law_move(mat6 K, double x, double y, double angle)
{
    const pose T = {.R = mat3_rot_z(angle), .p = {{x, y, 0}}};
    return mat6_symmetric(mat6_congruence(se3_adjoint(T), K));
}

void beam_law_set_error(beam_law *law, double relative_error)
{
    law->relative_error = relative_error;
    for (int i = 0; i < 36; i++) {
        law->entry_error.a[i / 6][i % 6] = relative_error;
    }
}

beam_law beam_law_turn(beam_law law, double angle)
{
    if (angle == 0) {
        return law;
    }
    const mat6 K = beam_law_move(law.K, 0, 0, angle);
    const double c = fabs(cos(angle)), s = fabs(sin(angle));
    mat6 R = mat6_identity(), E = law.entry_error;
    for (int b = 0; b < 6; b += 3) {
        R.a[b][b] = R.a[b + 1][b + 1] = c;
        R.a[b][b + 1] = R.a[b + 1][b] = s;
    }
    for (int i = 0; i < 36; i++) {
        E.a[i / 6][i % 6] *= sqrt(law.K.a[i / 6][i / 6] * law.K.a[i % 6][i % 6]);
    }
    E = mat6_congruence(R, E);
    double most = 0;
    for (int i = 0; i < 36; i++) {
        double *e = &E.a[i / 6][i % 6];
        *e /= sqrt(K.a[i / 6][i / 6] * K.a[i % 6][i % 6]);
        most = *e <= most ? most : *e;
    }
    const double x = law.mass_centre[0], y = law.mass_centre[1];
    law.K = K;
    law.mass_centre[0] = cos(angle) * x + sin(angle) * y;
    law.mass_centre[1] = cos(angle) * y - sin(angle) * x;
    law.entry_error = E;
    law.relative_error = most;
    return law;
}

status beam_law_check(const beam_law *law)
{
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 6; j++) {
            const double a = law->K.a[i][j], b = law->K.a[j][i];
            const double size = sqrt(fabs(law->K.a[i][i] * law->K.a[j][j]));
            if (!isfinite(a)) {
                return status_fail(ERR_NUMERIC, "section stiffness: K[%d][%d] is not finite", i, j);
            }
            if (!(fabs(a - b) <= symmetry_tolerance * size)) {
                return status_fail(
                    ERR_NUMERIC,
                    "section stiffness: K[%d][%d] = %.9g and K[%d][%d] = %.9g are not symmetric", i,
                    j, a, j, i, b);
            }
        }
    }
    mat6 inverse;
    if (!mat6_inverse_spd(law->K, &inverse)) {
        return status_fail(ERR_NUMERIC,
                           "section stiffness: the 6x6 matrix is not positive definite");
    }
    return OK;
}
