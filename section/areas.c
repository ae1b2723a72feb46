// section/areas.c
#include "section/plane.h"
#include "section/section.h"

#include <string.h>

status section_areas(const mesh *m, int nmaterial, double *area)
{
    status st = OK;
    plane p = {0};
    memset(area, 0, (size_t)nmaterial * sizeof *area);
    TRY(plane_make(m, 2 * m->order, &p)); // det J of curved elements is of that degree at most
    for (int b = 0; b < m->nblock; b++) {
        for (int i = 0; i < m->block[b].nelem; i++) {
            plane_element e;
            TRY(plane_element_at(&p, b, i, &e));
            for (int q = 0; q < e.npoint && e.material < nmaterial; q++) {
                area[e.material] += e.dA[q] * p.length * p.length;
            }
        }
    }

done:
    plane_free(&p);
    return st;
}
