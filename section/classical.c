// section/classical.c
#include "section/integrals.h"
#include "section/plane.h"
#include "section/section.h"

#include <math.h>

// more degrees of the quadrature where the modulus varies within elements: smooth gradings are
// then as exact as the geometry
enum { GRADED_DEGREE = 6 };

// Where the sums are taken: places are scaled by `length` and counted from `centre`.
typedef struct summing {
    const plane *plane;
    section_integrals *sum;
    // of the last element's material and frame: neighbours mostly have the same
    const material *material;
    const material_frame *frame;
    rod_moduli moduli;
} summing;

static moments point_moments(const summing *g, const plane_element *e, int q)
{
    const double a = g->plane->length, x = a * e->x[q], y = a * e->y[q], dA = a * a * e->dA[q];
    return (moments){dA, dA * x, dA * y, dA * x * x, dA * y * y, dA * x * y};
}

static void add_whole(summing *g, const plane_element *e)
{
    moments all = {0};
    for (int q = 0; q < e->npoint; q++) {
        const moments m = point_moments(g, e, q);
        all.one += m.one;
        all.x += m.x;
        all.y += m.y;
        all.xx += m.xx;
        all.yy += m.yy;
        all.xy += m.xy;
    }
    integrals_add(g->sum, &all, &g->moduli, 1);
}

// the modulus or its directions vary within the element
static status add_points(summing *g, const plane_element *e)
{
    status st = OK;
    for (int q = 0; q < e->npoint; q++) {
        const double x = g->plane->centre[0] + g->plane->length * e->x[q];
        const double y = g->plane->centre[1] + g->plane->length * e->y[q];
        const moments piece = point_moments(g, e, q);
        rod_moduli moduli = g->moduli;
        double grade = 1;
        TRY(material_check_grade(g->material, x, y, &grade));
        if (g->frame && g->frame->polar) {
            const double dx = x - g->frame->centre[0], dy = y - g->frame->centre[1];
            const double r = hypot(dx, dy), c = r > 0 ? -dy / r : 0, s = r > 0 ? dx / r : 1;
            moduli = rod_moduli_turned(&moduli, c, s);
        }
        integrals_add(g->sum, &piece, &moduli, grade);
    }

done:
    return st;
}

static status add_element(summing *g, const plane_element *e, const material *m,
                          const material_frame *frame)
{
    const bool directed = m->kind != MATERIAL_ISOTROPIC;
    frame = directed ? frame : NULL;
    if (m != g->material || frame != g->frame) {
        g->material = m;
        g->frame = frame;
        g->moduli = rod_moduli_of(m, frame);
    }
    if (material_is_graded(m) || (frame && frame->polar)) {
        return add_points(g, e);
    }
    add_whole(g, e);
    return OK;
}

static bool any_graded(const mesh *m, const material *materials)
{
    for (int b = 0; b < m->nblock; b++) {
        for (int k = 0; k < m->block[b].nelem; k++) {
            if (material_is_graded(&materials[m->block[b].material[k]])) {
                return true;
            }
        }
    }
    return false;
}

static const material_frame *frame_of(const mesh *m, const mesh_block *b, int k)
{
    return b->frame && b->frame[k] >= 0 ? &m->frame[b->frame[k]] : NULL;
}

status section_classical_mesh(const mesh *m, const material *materials, beam_law *out)
{
    status st = OK;
    plane p = {0};
    // x^2 det J has degree 2 p + 2 p - 1 at most along each direction of a curved quad, less on
    // triangles
    const int more = any_graded(m, materials) ? GRADED_DEGREE : 0;
    TRY(plane_make(m, 4 * m->order - 1 + more, &p));

    section_integrals sum = {.centre = {p.centre[0], p.centre[1]}};
    summing g = {.plane = &p, .sum = &sum};
    for (int b = 0; b < m->nblock; b++) {
        for (int k = 0; k < m->block[b].nelem; k++) {
            plane_element e;
            TRY(plane_element_at(&p, b, k, &e));
            TRY(add_element(&g, &e, &materials[e.material], frame_of(m, &m->block[b], k)));
        }
    }
    TRY(integrals_law(&sum, out));

done:
    plane_free(&p);
    return st;
}
