// section/integrals.c
#include "section/integrals.h"

enum { ZZ = 2, YZ = 3, XZ = 4 };

// docs/theory.md (2.9)
static rod_moduli moduli_of_stiffness(mat6 Q, double density)
{
    mat6 S = {0};
    if (!mat6_inverse_spd(Q, &S)) { // material_bind let it pass
        return (rod_moduli){0};
    }
    const double xz = S.a[XZ][XZ], yz = S.a[YZ][YZ], both = S.a[XZ][YZ];
    const double det = xz * yz - both * both;
    return (rod_moduli){
        .E = 1 / S.a[ZZ][ZZ],
        .Gx = yz / det,
        .Gy = xz / det,
        .Gxy = -both / det,
        .density = density,
    };
}

rod_moduli rod_moduli_of(const material *m, const material_frame *frame)
{
    if (m->kind == MATERIAL_ISOTROPIC) {
        const double G = material_shear_modulus(m);
        return (rod_moduli){.E = m->E, .Gx = G, .Gy = G, .density = m->density};
    }
    const mat6 Q = frame ? material_stiffness_along(m, frame->axes) : material_stiffness(m);
    return moduli_of_stiffness(Q, m->density);
}

rod_moduli rod_moduli_turned(const rod_moduli *m, double c, double s)
{
    return (rod_moduli){
        .E = m->E,
        .Gx = c * c * m->Gx + s * s * m->Gy - 2 * c * s * m->Gxy,
        .Gy = s * s * m->Gx + c * c * m->Gy + 2 * c * s * m->Gxy,
        .Gxy = c * s * (m->Gx - m->Gy) + (c * c - s * s) * m->Gxy,
        .density = m->density,
    };
}

static void moments_add(moments *sum, double c, const moments *piece)
{
    sum->one += c * piece->one;
    sum->x += c * piece->x;
    sum->y += c * piece->y;
    sum->xx += c * piece->xx;
    sum->yy += c * piece->yy;
    sum->xy += c * piece->xy;
}

void integrals_add(section_integrals *sum, const moments *piece, const rod_moduli *m, double grade)
{
    sum->area += piece->one;
    moments_add(&sum->E, grade * m->E, piece);
    moments_add(&sum->Gx, grade * m->Gx, piece);
    moments_add(&sum->Gy, grade * m->Gy, piece);
    moments_add(&sum->Gxy, grade * m->Gxy, piece);
    mass_add(&sum->mass, m->density, piece->one, piece->x, piece->y);
}

// docs/theory.md (2.3) and (2.5), in axes parallel to x and y: K does not care for the principal
// ones
status integrals_law(const section_integrals *i, beam_law *out)
{
    const moments *E = &i->E, *Gx = &i->Gx, *Gy = &i->Gy, *Gxy = &i->Gxy;
    if (!(i->area > 0)) {
        return status_fail(ERR_INPUT, "section: nothing is left of it, its area is zero");
    }
    const double x = E->x / E->one, y = E->y / E->one; // the stiffness centre
    mat6 K = {0};
    K.a[NX][NX] = Gx->one;
    K.a[NY][NY] = Gy->one;
    K.a[NX][NY] = K.a[NY][NX] = Gxy->one;
    K.a[NZ][NZ] = E->one;
    K.a[MX][MX] = E->yy - E->one * y * y;
    K.a[MY][MY] = E->xx - E->one * x * x;
    K.a[MX][MY] = K.a[MY][MX] = -(E->xy - E->one * x * y);
    K.a[MZ][MZ] = Gy->xx - 2 * x * Gy->x + x * x * Gy->one   // int Gy (x - x_nc)^2
                  + Gx->yy - 2 * y * Gx->y + y * y * Gx->one // int Gx (y - y_nc)^2
                  - 2 * (Gxy->xy - x * Gxy->y - y * Gxy->x + x * y * Gxy->one);
    *out = (beam_law){
        .K = beam_law_move(K, -(i->centre[0] + x), -(i->centre[1] + y), 0),
        .area = i->area,
    };
    mass_into_law(&i->mass, i->centre, out);
    return OK;
}
