// section/mass.c
#include "section/mass.h"

#include "section/integrals.h"
#include "section/plane.h"

// weight times int of 1, x, y, x^2, y^2, x y of one element, in m about the section's origin
static void add_element(const plane *p, const plane_element *e, double weight, moments *sum)
{
    const double a = p->length;
    for (int q = 0; q < e->npoint; q++) {
        const double x = p->centre[0] + a * e->x[q], y = p->centre[1] + a * e->y[q];
        const double dA = weight * a * a * e->dA[q];
        sum->one += dA;
        sum->x += x * dA;
        sum->y += y * dA;
        sum->xx += x * x * dA;
        sum->yy += y * y * dA;
        sum->xy += x * y * dA;
    }
}

// int rho [1, -hat(r); hat(r), -hat(r)^2] with r = (x, y, 0)
static mat6 mass_matrix(const moments *m)
{
    return (mat6){{
        {m->one, 0, 0, 0, 0, -m->y},
        {0, m->one, 0, 0, 0, m->x},
        {0, 0, m->one, m->y, -m->x, 0},
        {0, 0, m->y, m->yy, -m->xy, 0},
        {0, 0, -m->x, -m->xy, m->xx, 0},
        {-m->y, m->x, 0, 0, 0, m->xx + m->yy},
    }};
}

void mass_add(mass_sum *sum, double density, double area, double x, double y)
{
    sum->unknown = sum->unknown || !(density > 0);
    sum->one += density * area;
    sum->x += density * x;
    sum->y += density * y;
}

void mass_into_law(const mass_sum *sum, const double centre[2], beam_law *law)
{
    if (!sum->unknown && sum->one > 0) {
        law->mass = sum->one;
        law->mass_centre[0] = centre[0] + sum->x / sum->one;
        law->mass_centre[1] = centre[1] + sum->y / sum->one;
    }
}

status section_mass_of(const mesh *m, const material *materials, section_mass *out)
{
    status st = OK;
    plane p = {0};
    moments area = {0}, mass = {0};
    bool known = true;
    // exact for x^2 on curved elements too: the map and its det J have degree p and 2 p - 1 or less
    TRY(plane_make(m, 4 * m->order, &p));
    for (int b = 0; b < m->nblock; b++) {
        for (int k = 0; k < m->block[b].nelem; k++) {
            plane_element e;
            TRY(plane_element_at(&p, b, k, &e));
            const double density = materials[e.material].density;
            add_element(&p, &e, 1, &area);
            add_element(&p, &e, density, &mass);
            known = known && density > 0;
        }
    }
    *out = (section_mass){.centre = {area.x / area.one, area.y / area.one}, .known = known};
    if (known) {
        out->mass = mass.one;
        out->mass_centre[0] = mass.x / mass.one;
        out->mass_centre[1] = mass.y / mass.one;
        out->matrix = mass_matrix(&mass);
    }

done:
    plane_free(&p);
    return st;
}
