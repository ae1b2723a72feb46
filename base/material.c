// base/material.c
#include "base/material.h"

double material_shear_modulus(const material *m)
{
    return m->E / (2 * (1 + m->nu));
}

static mat6 isotropic(const material *m)
{
    const double G = material_shear_modulus(m);
    const double lambda = m->E * m->nu / ((1 + m->nu) * (1 - 2 * m->nu));
    mat6 Q = {0};
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            Q.a[i][j] = lambda + (i == j ? 2 * G : 0);
        }
        Q.a[i + 3][i + 3] = G;
    }
    return Q;
}

mat6 material_stiffness_along(const material *m, mat3 axes)
{
    return m->kind == MATERIAL_ISOTROPIC
               ? isotropic(m)
               : mat6_congruence(material_frame_strain_map(axes), m->in_frame);
}

mat6 material_stiffness_in(const material *m, const material_frame *frame, double x, double y)
{
    return frame && m->kind != MATERIAL_ISOTROPIC
               ? material_stiffness_along(m, material_frame_axes_at(frame, x, y))
               : material_stiffness(m);
}

mat6 material_stiffness(const material *m)
{
    static const mat3 unturned = {{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}}}; // 1 = z, 2 = x, 3 = y
    return material_stiffness_along(m, unturned);
}

static bool is_modulus(double E)
{
    return E >= MATERIAL_SMALLEST_MODULUS && E <= MATERIAL_LARGEST_MODULUS;
}

material material_at(const material *m, double s)
{
    material frozen = *m;
    frozen.modulus.s = s;
    if (material_varies(m) && !material_is_graded(m)) {
        const double E = place_field_at(&frozen.modulus, 0, 0);
        if (is_modulus(E)) {
            frozen.E = E;
            frozen.modulus = (place_field){.value = E};
        } else {
            frozen.modulus.across = true; // whoever looks at a place refuses it
        }
    }
    return frozen;
}

double material_grade(const material *m, double x, double y)
{
    return m->modulus.at ? place_field_at(&m->modulus, x, y) / m->E : 1;
}

status material_check_grade(const material *m, double x, double y, double *grade)
{
    *grade = material_grade(m, x, y);
    const double E = *grade * m->E;
    if (is_modulus(E)) {
        return OK;
    }
    return status_fail_at(ERR_INPUT, m->at.line, m->at.column,
                          "material '%s': E = %.6g MPa at x = %.6g mm, y = %.6g mm, s = %.6g mm: "
                          "it must be more than 0, %g to %g MPa",
                          m->name ? m->name : "", 1e-6 * E, 1e3 * x, 1e3 * y, 1e3 * m->modulus.s,
                          1e-6 * MATERIAL_SMALLEST_MODULUS, 1e-6 * MATERIAL_LARGEST_MODULUS);
}
