// section/classical.c
#include "section/integrals.h"
#include "section/plane.h"
#include "section/section.h"

static void moments_add(moments *sum, double c, const moments *piece)
{
    sum->one += c * piece->one;
    sum->x += c * piece->x;
    sum->y += c * piece->y;
    sum->xx += c * piece->xx;
    sum->yy += c * piece->yy;
    sum->xy += c * piece->xy;
}

void integrals_add(section_integrals *sum, const moments *piece, const material *m)
{
    sum->area += piece->one;
    moments_add(&sum->E, m->E, piece);
    moments_add(&sum->G, material_shear_modulus(m), piece);
}

// docs/theory.md (2.3) and (2.5), in axes parallel to x and y: K does not care for the principal
// ones
status integrals_law(const section_integrals *i, beam_law *out)
{
    const moments *E = &i->E, *G = &i->G;
    if (!(i->area > 0)) {
        return status_fail(ERR_INPUT, "section: nothing is left of it, its area is zero");
    }
    const double x = E->x / E->one, y = E->y / E->one; // the stiffness centre
    mat6 K = {0};
    K.a[NX][NX] = K.a[NY][NY] = G->one;
    K.a[NZ][NZ] = E->one;
    K.a[MX][MX] = E->yy - E->one * y * y;
    K.a[MY][MY] = E->xx - E->one * x * x;
    K.a[MX][MY] = K.a[MY][MX] = -(E->xy - E->one * x * y);
    K.a[MZ][MZ] = G->xx + G->yy - 2 * (x * G->x + y * G->y) + (x * x + y * y) * G->one;
    *out = (beam_law){
        .K = beam_law_move(K, -(i->centre[0] + x), -(i->centre[1] + y), 0),
        .area = i->area,
    };
    return OK;
}

// plain moments of one element, scaled lengths
static moments element_moments(const plane_element *e)
{
    moments m = {0};
    for (int q = 0; q < e->npoint; q++) {
        const double x = e->x[q], y = e->y[q], dA = e->dA[q];
        moments_add(&m, dA, &(moments){1, x, y, x * x, y * y, x * y});
    }
    return m;
}

status section_classical_mesh(const mesh *m, const material *materials, beam_law *out)
{
    status st = OK;
    plane p = {0};
    // x^2 det J has degree 2 p + 2 p - 1 at most along each direction of a curved quad, less on
    // triangles
    TRY(plane_make(m, 4 * m->order - 1, &p));

    const double a = p.length, a2 = a * a;
    section_integrals sum = {.centre = {p.centre[0], p.centre[1]}};
    for (int b = 0; b < m->nblock; b++) {
        for (int k = 0; k < m->block[b].nelem; k++) {
            plane_element e;
            TRY(plane_element_at(&p, b, k, &e));
            const moments u = element_moments(&e);
            const moments piece = {a2 * u.one,     a2 * a * u.x,   a2 * a * u.y,
                                   a2 * a2 * u.xx, a2 * a2 * u.yy, a2 * a2 * u.xy};
            integrals_add(&sum, &piece, &materials[e.material]);
        }
    }
    TRY(integrals_law(&sum, out));

done:
    plane_free(&p);
    return st;
}
