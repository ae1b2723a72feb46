// section/warping_constant.c
#include "section/answers.h"

#include "base/beam_law.h"

#include <math.h>

// what one pass over the section sums up, in scaled lengths
typedef struct fit {
    mat3 A;         // int E (1, x, y)^T (1, x, y)
    vec3 right;     // int E (1, x, y)^T omega
    double part[3]; // omega's mean and linear parts, once they are known
    double square;  // int E (omega - part (1, x, y))^2
} fit;

typedef struct torsion {
    plane *plane;
    const material *materials;
    const section_warping *warping;
    double modulus; // that E is measured in [Pa]
} torsion;

// warping along z per twist, per scaled length squared
static double omega_at(const torsion *t, const plane_element *e, int q)
{
    const section_warping *g = t->warping;
    const double *w = g->w + 3 * (size_t)MZ * (size_t)g->nnode;
    double sum = 0;
    for (int i = 0; i < e->nnode; i++) {
        sum += e->N[q * e->nnode + i] * w[3 * (size_t)e->node[i] + 2];
    }
    return sum / (g->psi.a[MZ][MZ] * t->plane->length * t->plane->length);
}

static void add_point(double weight, double x, double y, double omega, fit *f)
{
    const double basis[3] = {1, x, y};
    double rest = omega;
    for (int i = 0; i < 3; i++) {
        rest -= f->part[i] * basis[i];
        f->right.a[i] += weight * basis[i] * omega;
        for (int j = 0; j < 3; j++) {
            f->A.a[i][j] += weight * basis[i] * basis[j];
        }
    }
    f->square += weight * rest * rest;
}

static status pass(const torsion *t, fit *f)
{
    status st = OK;
    plane *p = t->plane;
    const mesh *m = p->mesh;
    *f = (fit){.part = {f->part[0], f->part[1], f->part[2]}};
    for (int b = 0; b < m->nblock; b++) {
        for (int k = 0; k < m->block[b].nelem; k++) {
            plane_element e;
            TRY(plane_element_at(p, b, k, &e));
            const int frame = section_frame_of(&m->block[b], k);
            for (int q = 0; q < e.npoint; q++) {
                const double x = p->centre[0] + p->length * e.x[q];
                const double y = p->centre[1] + p->length * e.y[q];
                const double E =
                    section_axial_modulus(m, t->materials, e.material, frame, x, y) / t->modulus;
                add_point(E * e.dA[q], e.x[q], e.y[q], omega_at(t, &e, q), f);
            }
        }
    }

done:
    return st;
}

// part = A^-1 right, inside a unit matrix so that the scaled 6x6 routine serves
static bool find_part(fit *f)
{
    mat6 padded = mat6_identity(), inverse;
    for (int i = 0; i < 9; i++) {
        padded.a[i / 3][i % 3] = f->A.a[i / 3][i % 3];
    }
    if (!mat6_inverse_spd(padded, &inverse)) {
        return false;
    }
    for (int i = 0; i < 3; i++) {
        f->part[i] = 0;
        for (int j = 0; j < 3; j++) {
            f->part[i] += inverse.a[i][j] * f->right.a[j];
        }
    }
    return true;
}

status section_warping_constant(const mesh *m, const material *materials,
                                const section_warping *warping, double *out)
{
    status st = OK;
    plane p = {0};
    fit f = {0};
    // omega^2 has twice the element's degree, and det J on curved elements
    TRY(plane_make(m, 3 * m->order, &p));
    const torsion t = {&p, materials, warping, materials[m->block[0].material[0]].E};
    TRY(pass(&t, &f));
    if (!find_part(&f)) {
        TRY(status_fail(ERR_NUMERIC, "section: its warping has no linear part to remove"));
    }
    TRY(pass(&t, &f));
    *out = f.square * t.modulus * pow(p.length, 6);

done:
    plane_free(&p);
    return st;
}
