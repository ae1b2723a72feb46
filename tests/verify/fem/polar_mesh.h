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

// a plane mesh, the levels on it, and what the segment is asked for
typedef struct column_model {
    mesh plane;
    double *level;
    int nlevel;
    segment_case c;
    segment_source source;
} column_model;

static inline void column_model_free(column_model *m)
{
    mesh_free(&m->plane);
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

// the same mesh at the orders that the segment asks for
static inline status model_plane(void *self, const segment_mesh *ask, mesh *out)
{
    const column_model *m = self;
    return ask->order == m->plane.order ? mesh_copy(&m->plane, out)
                                        : mesh_of_order(&m->plane, ask->order, out);
}

// m must stay where it is: the source points into it
static inline status extrude_plainly(int layers, double grading, double length, column_model *m)
{
    status st = OK;
    const int p = m->plane.order;
    m->nlevel = layers * p + 1;
    TRY(TAKE(m->level, (size_t)m->nlevel));
    graded_levels(layers, p, grading, length, m->level);
    m->c = segment_case_default();
    m->c.length = length;
    m->c.order = p;
    m->c.layers = layers;
    m->c.grading = grading;
    m->source = (segment_source){.self = m, .plane = model_plane};
    for (int i = 0; i < m->plane.nnode; i++) {
        m->source.radius =
            fmax(m->source.radius, hypot(m->plane.xyz[3 * i], m->plane.xyz[3 * i + 1]));
    }

done:
    return st;
}

static inline status polar_model(const polar_segment *s, const material *materials, int base,
                                 int tip, column_model *m)
{
    status st = OK;
    TRY(polar_mesh(s, &m->plane));
    TRY(extrude_plainly(s->layers, s->grading, s->length, m));
    m->source.materials = materials;
    m->c.base = base;
    m->c.tip = tip;

done:
    return st;
}

static inline status model_solve(column_model *m, int nload, const segment_load *loads,
                                 const double (*point)[2], int keep, segment_result *r)
{
    segment_load items[8];
    segment_case c = m->c;
    memcpy(items, loads, (size_t)nload * sizeof *items);
    c.loads = (key_list){.count = nload, .items = items};
    return segment_solve(&c, &m->source, point, keep, r);
}
