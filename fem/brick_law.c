// fem/brick_law.c
#include "fem/brick_law.h"

status brick_law_at(const body *b, int block, int e, int index, double s, brick_law *out)
{
    status st = OK;
    const mesh_block *k = &b->plane->block[block];
    const material *m = &b->spec.materials[index];
    brick_law law = {.m = m, .isotropic = m->kind == MATERIAL_ISOTROPIC};
    if (law.isotropic) {
        law.mu = material_shear_modulus(m);
        law.lambda = m->E * m->nu / ((1 + m->nu) * (1 - 2 * m->nu));
    } else if (k->frame && k->frame[e] >= 0) {
        law.framed = true;
        law.frame = b->plane->frame[k->frame[e]];
        if (b->spec.shape.frame) {
            TRY(b->spec.shape.frame(b->spec.shape.self, s, k->frame[e], &law.frame));
        }
    }
    *out = law;

done:
    return st;
}

status brick_grade(const brick_law *law, double x, double y, double s, double *grade)
{
    if (!law->m->modulus.at) {
        *grade = 1;
        return OK;
    }
    const material frozen = material_at(law->m, s);
    const status st = material_check_grade(&frozen, x, y, grade);
    *grade *= frozen.E / law->m->E; // where it varies along s alone, it is frozen into E
    return st;
}

mat6 brick_section_stiffness(const brick_law *law, double x, double y)
{
    return mat6_symmetric(material_stiffness_in(law->m, law->framed ? &law->frame : NULL, x, y));
}

double brick_modulus_along(const brick_law *law)
{
    mat6 S;
    if (law->isotropic || !mat6_inverse_spd(brick_section_stiffness(law, 0, 0), &S)) {
        return law->m->E;
    }
    return 1 / S.a[2][2];
}
