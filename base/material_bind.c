// base/material_bind.c
// From the constants that a person gives to the kind, and whether they are those of a solid.
#include "base/material.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>

// How near to the end of what is positive definite the constants may come: rounding of the
// constants themselves decides below. nu = 0.4999 has 1 - 3 nu^2 - 2 nu^3 = 4.5e-4.
static const double least_determinant = 1e-6;
// Printed tables are symmetric in their digits: more apart than this is a slip of the pen.
static const double symmetry_tolerance = 1e-6;
// What the solvers were tried on: nearer to 0.5 the pressure eats the digits.
static const double least_nu = -0.999, most_nu = 0.4999;

enum { RATIO_COUNT = 3, WORDS = 400 };

static status refuse(const material *m, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

static status refuse(const material *m, const char *format, ...)
{
    char words[WORDS];
    va_list args;
    va_start(args, format);
    (void)vsnprintf(words, sizeof words, format, args);
    va_end(args);
    return status_fail_at(ERR_INPUT, m->at.line, m->at.column, "material '%s': %s",
                          m->name ? m->name : "", words);
}

// --- which constants are there

typedef struct constant {
    const char *name;
    double value;
    bool given;
} constant;

static bool positive(double value)
{
    return value > 0;
}

// the constants that belong to one kind only
enum { CONSTANT_COUNT = 10 };
static void list_constants(const material *m, constant list[CONSTANT_COUNT])
{
    const constant all[CONSTANT_COUNT] = {
        {"nu", m->nu, !isnan(m->nu)},       {"E2", m->E2, positive(m->E2)},
        {"E3", m->E3, positive(m->E3)},     {"G12", m->G12, positive(m->G12)},
        {"G13", m->G13, positive(m->G13)},  {"G23", m->G23, positive(m->G23)},
        {"nu12", m->nu12, !isnan(m->nu12)}, {"nu13", m->nu13, !isnan(m->nu13)},
        {"nu23", m->nu23, !isnan(m->nu23)}, {"", 0, false},
    };
    for (int i = 0; i < CONSTANT_COUNT; i++) {
        list[i] = all[i];
    }
}

// constants from `first` up to `end` must be there, all others must not; 0 says nothing (structs
// that no case filled)
static status check_given(const material *m, const char *kind, int first, int end)
{
    constant list[CONSTANT_COUNT];
    list_constants(m, list);
    for (int i = 0; list[i].name[0]; i++) {
        const bool wanted = i >= first && i < end;
        if (wanted && !list[i].given) {
            return refuse(m, "%s is missing: it is %s", list[i].name, kind);
        }
        if (!wanted && list[i].given && list[i].value != 0) {
            return refuse(m, "%s does not belong here: it is %s", list[i].name, kind);
        }
    }
    return OK;
}

// --- isotropic

// E as a number: the one to which others are referred where it is graded
static status take_modulus(material *m)
{
    status st = OK;
    if (mark_given(m->table.at)) {
        TRY(field_table_check(&m->table));
        m->modulus = field_table_place(&m->table);
    }
    if (m->modulus.at) {
        const double E = place_field_at(&m->modulus, 0, 0);
        m->E = E > 0 && isfinite(E) ? E : 1;
    } else if (m->modulus.value > 0) {
        m->E = m->modulus.value;
    }

done:
    return st;
}

static status bind_isotropic(material *m)
{
    status st = OK;
    m->kind = MATERIAL_ISOTROPIC;
    TRY(take_modulus(m));
    TRY(check_given(m, "isotropic, by E and nu", 0, 1));
    if (!(m->nu > -1 && m->nu < 0.5)) {
        return refuse(m, "nu = %.6g breaks -1 < nu < 0.5%s", m->nu,
                      m->nu == 0.5 ? " (for a rubber take 0.49)" : "");
    }
    if (m->nu < least_nu || m->nu > most_nu) {
        return refuse(m, "nu = %.8g is too near to the end of -1 < nu < 0.5: %g to %g", m->nu,
                      least_nu, most_nu);
    }

done:
    return st;
}

// --- orthotropic

static status check_ratio(const material *m, int i, int j, double nu, double Ei, double Ej)
{
    return nu * nu < Ei / Ej ? OK
                             : refuse(m, "nu%d%d = %.6g breaks nu%d%d^2 < E%d/E%d = %.6g", i, j, nu,
                                      i, j, i, j, Ei / Ej);
}

// docs/theory.md (1.9)
static status check_orthotropic(const material *m)
{
    status st = OK;
    const double nu21 = m->nu12 * m->E2 / m->E1, nu31 = m->nu13 * m->E3 / m->E1;
    const double nu32 = m->nu23 * m->E3 / m->E2;
    const double left = 1 - m->nu12 * nu21 - m->nu23 * nu32 - nu31 * m->nu13;
    const double determinant = left - 2 * nu21 * nu32 * m->nu13;
    TRY(check_ratio(m, 1, 2, m->nu12, m->E1, m->E2));
    TRY(check_ratio(m, 1, 3, m->nu13, m->E1, m->E3));
    TRY(check_ratio(m, 2, 3, m->nu23, m->E2, m->E3));
    if (!(determinant > least_determinant)) {
        return refuse(m,
                      "1 - nu12 nu21 - nu23 nu32 - nu31 nu13 - 2 nu21 nu32 nu13 = %.4g, it must be "
                      "more than %s",
                      determinant, determinant > 0 ? "0 by 1e-6" : "0");
    }

done:
    return st;
}

static mat6 orthotropic_compliance(const material *m)
{
    const double s12 = -m->nu12 / m->E1, s13 = -m->nu13 / m->E1, s23 = -m->nu23 / m->E2;
    return (mat6){{
        {1 / m->E1, s12, s13, 0, 0, 0},
        {s12, 1 / m->E2, s23, 0, 0, 0},
        {s13, s23, 1 / m->E3, 0, 0, 0},
        {0, 0, 0, 1 / m->G23, 0, 0},
        {0, 0, 0, 0, 1 / m->G13, 0},
        {0, 0, 0, 0, 0, 1 / m->G12},
    }};
}

static status own_orthotropic(const material *m, mat6 *Q)
{
    status st = OK;
    TRY(check_given(m, "orthotropic, by E1, E2, E3, G12, G13, G23, nu12, nu13 and nu23", 1,
                    CONSTANT_COUNT));
    TRY(check_orthotropic(m));
    if (!mat6_inverse_spd(orthotropic_compliance(m), Q)) {
        return refuse(m, "its compliance is not positive definite to rounding");
    }

done:
    return st;
}

// --- anisotropic

static status check_symmetry(const material *m, const double *C)
{
    for (int i = 0; i < 6; i++) {
        if (!(C[7 * i] > 0)) {
            return refuse(m, "stiffness: row %d, column %d is %.6g Pa, it must be more than 0",
                          i + 1, i + 1, C[7 * i]);
        }
    }
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < i; j++) {
            const double low = C[6 * i + j], high = C[6 * j + i];
            if (!(fabs(low - high) <= symmetry_tolerance * sqrt(C[7 * i] * C[7 * j]))) {
                return refuse(m,
                              "stiffness: it must be symmetric, and row %d, column %d is %.8g Pa "
                              "while row %d, column %d is %.8g Pa",
                              i + 1, j + 1, low, j + 1, i + 1, high);
            }
        }
    }
    return OK;
}

// The leading minors of the matrix scaled to a unit diagonal, by elimination: the first that is not
// positive breaks Sylvester's criterion.
static status check_minors(const material *m, mat6 a)
{
    double minor = 1;
    for (int k = 0; k < 6; k++) {
        minor *= a.a[k][k];
        if (!(a.a[k][k] > least_determinant)) {
            return refuse(m,
                          "stiffness: the determinant of its first %d rows and columns, over the "
                          "product of their diagonal, is %.4g: it must be more than %s",
                          k + 1, minor, minor > 0 ? "0, by 1e-6 of the one before" : "0");
        }
        for (int i = k + 1; i < 6; i++) {
            for (int j = k + 1; j < 6; j++) {
                a.a[i][j] -= a.a[i][k] * a.a[k][j] / a.a[k][k];
            }
        }
    }
    return OK;
}

static status own_anisotropic(const material *m, mat6 *Q)
{
    status st = OK;
    mat6 scaled;
    const double *C = m->stiffness.a;
    TRY(check_given(m, "anisotropic, by its stiffness", 0, 0));
    if (m->stiffness.nrow != 6) {
        return status_fail_at(ERR_INPUT, m->stiffness.at.line, m->stiffness.at.column,
                              "material '%s': stiffness: expected 6 rows of 6, found %d",
                              m->name ? m->name : "", m->stiffness.nrow);
    }
    TRY(check_symmetry(m, C));
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 6; j++) {
            Q->a[i][j] = (C[6 * i + j] + C[6 * j + i]) / 2;
            scaled.a[i][j] = Q->a[i][j] / sqrt(C[7 * i] * C[7 * j]);
        }
    }
    TRY(check_minors(m, scaled));

done:
    return st;
}

// --- what all that are not isotropic share

// the own axes within a frame: rows along the frame's 1, 2, 3
static mat3 own_axes(const material *m)
{
    const double c = cos(m->plane_angle), s = sin(m->plane_angle);
    const double cf = cos(m->fibre_angle), sf = sin(m->fibre_angle);
    return (mat3){{{cf, sf * c, sf * s}, {-sf, cf * c, cf * s}, {0, -s, c}}};
}

static status bind_turned(material *m, mat6 own)
{
    mat6 S;
    m->in_frame = mat6_congruence(material_frame_strain_map(own_axes(m)), own);
    if (!mat6_inverse_spd(material_stiffness(m), &S)) {
        return refuse(m, "its stiffness is not positive definite to rounding");
    }
    m->E = 1 / S.a[2][2];
    m->nu = -(S.a[0][2] + S.a[1][2]) / 2 / S.a[2][2];
    return OK;
}

static void forget_not_given(material *m)
{
    double *ratio[RATIO_COUNT] = {&m->nu12, &m->nu13, &m->nu23};
    for (int i = 0; i < RATIO_COUNT; i++) {
        *ratio[i] = isnan(*ratio[i]) ? 0 : *ratio[i];
    }
}

status material_bind(material *m)
{
    status st = OK;
    mat6 own = {0};
    if (m->E1 > 0) {
        m->kind = MATERIAL_ORTHOTROPIC;
        TRY(own_orthotropic(m, &own));
        TRY(bind_turned(m, own));
    } else if (m->stiffness.a) {
        m->kind = MATERIAL_ANISOTROPIC;
        TRY(own_anisotropic(m, &own));
        TRY(bind_turned(m, own));
    } else {
        TRY(bind_isotropic(m));
    }
    forget_not_given(m);

done:
    return st;
}
