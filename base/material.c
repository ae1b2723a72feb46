// base/material.c
#include "base/material.h"

static const key keys[] = {
    {.name = "E",
     .kind = KEY_REAL,
     .dimension = DIM_STRESS,
     .min = 1e-3,
     .max = 1e16,
     .required = true,
     .offset = offsetof(material, E),
     .about = "Young's modulus"},
    {.name = "nu",
     .kind = KEY_REAL,
     .min = -0.999,
     .max = 0.4999,
     .required = true,
     .offset = offsetof(material, nu),
     .about = "Poisson's ratio"},
    {.name = "linear_strain",
     .kind = KEY_REAL,
     .min = 1e-9,
     .max = 10,
     .offset = offsetof(material, linear_strain),
     .about =
         "largest strain at which the material stays close to linear; larger ones are pointed out"},
};

const key_table material_keys = {
    .name = "material", .size = sizeof(material), .nkey = sizeof keys / sizeof *keys, .keys = keys};

double material_shear_modulus(const material *m)
{
    return m->E / (2 * (1 + m->nu));
}

mat6 material_stiffness(const material *m)
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

status material_bind(material *m)
{
    m->kind = MATERIAL_ISOTROPIC;
    return OK;
}

material material_at(const material *m, double s)
{
    material frozen = *m;
    frozen.modulus.s = s;
    return frozen;
}

double material_grade(const material *m, double x, double y)
{
    return m->modulus.at ? place_field_at(&m->modulus, x, y) / m->E : 1;
}

mat6 material_stiffness_in(const material *m, const material_frame *frame, double x, double y)
{
    (void)frame, (void)x, (void)y;
    return material_stiffness(m);
}
