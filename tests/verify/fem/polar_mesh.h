// tests/verify/fem/polar_mesh.h
// A segment of the paper's annulus, made without the meshes room: quads on a polar grid, and levels
// graded to both ends.
#pragma once

#include "base/memory.h"
#include "fem/segment.h"
#include "tests/test.h"

#include <string.h>

static const double PI = 3.14159265358979323846;

typedef struct polar_segment {
    double outer, inner;  // [m]; inner 0 is not offered
    double middle, width; // of the stiff sector [rad]; width 0: none
    int soft, stiff;      // elements along the two arcs
    int radial, order, layers;
    double grading, length;
} polar_segment;

// the prototype's section and Fig. 4's length
static inline polar_segment fig4_segment(void)
{
    return (polar_segment){.outer = 4e-3,
                           .inner = 3.2e-3,
                           .middle = PI,
                           .width = PI / 8,
                           .soft = 12,
                           .stiff = 2,
                           .radial = 1,
                           .order = 3,
                           .layers = 10,
                           .grading = 15,
                           .length = 20e-3};
}

typedef struct column_model {
    mesh plane, solid;
    double *level;
    segment_model model;
} column_model;

static inline void column_model_free(column_model *m)
{
    mesh_free(&m->plane);
    mesh_free(&m->solid);
    free(m->level);
    *m = (column_model){0};
}

// geometric growth to the middle, as the extrusion of the meshes room has it
static inline void graded_levels(int layers, int order, double grading, double length,
                                 double *level)
{
    double node[ELEMENT_MAX_ORDER + 1], total = 0;
    gauss_lobatto_nodes(order + 1, node);
    for (int pass = 0; pass < 2; pass++) {
        double z = 0;
        for (int i = 0; i < layers; i++) {
            const int step = i < layers - 1 - i ? i : layers - 1 - i, most = (layers - 1) / 2;
            const double h = most ? pow(grading, (double)step / most) : 1;
            for (int k = 0; pass && k <= order; k++) {
                level[i * order + k] = (z + h * (node[k] + 1) / 2) * length / total;
            }
            z += h;
        }
        total = z;
    }
}

static inline double polar_angle(const polar_segment *s, int element)
{
    const double from = s->middle - s->width / 2;
    return element <= s->stiff
               ? from + s->width * element / (s->stiff ? s->stiff : 1)
               : from + s->width + (2 * PI - s->width) * (element - s->stiff) / s->soft;
}

static inline status polar_mesh(const polar_segment *s, mesh *out)
{
    status st = OK;
    const int p = s->order, nangle = s->soft + s->stiff, around = nangle * p;
    const int across = s->radial * p + 1, nelem = nangle * s->radial;
    double node[ELEMENT_MAX_ORDER + 1];
    const shape quad = SHAPE_QUAD;
    gauss_lobatto_nodes(p + 1, node);
    TRY(mesh_make(p, around * across, 1, &quad, &nelem, out));
    for (int i = 0; i < around; i++) {
        const double a = polar_angle(s, i / p), b = polar_angle(s, i / p + 1);
        const double angle = a + (b - a) * (node[i % p] + 1) / 2;
        for (int j = 0; j < across; j++) {
            const int layer = j == across - 1 ? s->radial - 1 : j / p;
            const double t = (layer + (node[j - layer * p] + 1) / 2) / s->radial;
            const double r = s->inner + (s->outer - s->inner) * t;
            out->xyz[3 * (i * across + j)] = r * cos(angle);
            out->xyz[3 * (i * across + j) + 1] = r * sin(angle);
        }
    }
    for (int e = 0; e < nelem; e++) {
        const int turn = e / s->radial, ring = e % s->radial;
        out->block[0].material[e] = turn < s->stiff;
        // the first reference coordinate runs outwards, the second around: counter-clockwise
        for (int k = 0; k <= p; k++) {
            for (int j = 0; j <= p; j++) {
                out->block[0].conn[e * (p + 1) * (p + 1) + k * (p + 1) + j] =
                    (turn * p + k) % around * across + ring * p + j;
            }
        }
    }

done:
    return st;
}

// the solid's connectivity is that of base/mesh.h; the solver needs its nodes' count and order only
static inline status extrude_plainly(int layers, double grading, double length, column_model *m)
{
    status st = OK;
    const int p = m->plane.order, nlevel = layers * p + 1, none = 0;
    const shape hex = SHAPE_HEX;
    TRY(TAKE(m->level, (size_t)nlevel));
    graded_levels(layers, p, grading, length, m->level);
    TRY(mesh_make(p, m->plane.nnode * nlevel, 1, &hex, &none, &m->solid));
    m->model.plane = &m->plane;
    m->model.solid = &m->solid;
    m->model.nlevel = nlevel;
    m->model.level = m->level;

done:
    return st;
}

// m must stay where it is: the model points into it
static inline status polar_model(const polar_segment *s, const material *materials, int base,
                                 int tip, column_model *m)
{
    status st = OK;
    TRY(polar_mesh(s, &m->plane));
    TRY(extrude_plainly(s->layers, s->grading, s->length, m));
    m->model.materials = materials;
    m->model.base = base;
    m->model.tip = tip;

done:
    return st;
}
