// fem/segment_material.c
#include "fem/segment_material.h"

status segment_takes_material(const material *m)
{
    static const char *const kinds[] = {
        [MATERIAL_ISOTROPIC] = "graded",
        [MATERIAL_ORTHOTROPIC] = "orthotropic",
        [MATERIAL_ANISOTROPIC] = "anisotropic",
    };
    if (m->kind == MATERIAL_ISOTROPIC && !m->modulus.at) {
        return OK;
    }
    return status_fail_at(ERR_INPUT, m->at.line, m->at.column,
                          "material '%s' is %s: the 3D segment (fem) takes isotropic, uniform "
                          "materials only",
                          m->name ? m->name : "", kinds[m->kind]);
}

status segment_check_materials(const mesh *plane, const material *materials)
{
    status st = OK;
    for (int b = 0; b < plane->nblock; b++) {
        for (int e = 0; e < plane->block[b].nelem; e++) {
            TRY(segment_takes_material(&materials[plane->block[b].material[e]]));
        }
    }

done:
    return st;
}
