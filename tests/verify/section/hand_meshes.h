// tests/verify/section/hand_meshes.h
// Plane meshes made by hand, so that a test knows every element of them, and the sections of the
// references.
#pragma once

#include "section/section.h"
#include "tests/test.h"

#include <string.h>

static const double pi = 3.14159265358979323846;

// A lattice of n0 x n1 quads; place(u, v) with u, v in [0, 1] sets a node, material(u, v) an
// element by its middle.
typedef struct lattice {
    int order, n0, n1;
    bool closed; // u = 1 is u = 0
    void (*place)(double u, double v, double *xyz);
    int (*material)(double u, double v);
} lattice;

static inline int lattice_node(const lattice *g, int i, int j)
{
    const int columns = g->n0 * g->order + !g->closed;
    return j * columns + (g->closed ? i % columns : i);
}

static inline void lattice_element(const lattice *g, int a, int b, mesh *m)
{
    double t[ELEMENT_MAX_ORDER + 1];
    const int p = g->order, e = b * g->n0 + a;
    gauss_lobatto_nodes(p + 1, t);
    m->block[0].material[e] = g->material((a + 0.5) / g->n0, (b + 0.5) / g->n1);
    for (int j = 0; j <= p; j++) {
        for (int i = 0; i <= p; i++) {
            const int node = lattice_node(g, a * p + i, b * p + j);
            m->block[0].conn[e * (p + 1) * (p + 1) + j * (p + 1) + i] = node;
            g->place((a + (t[i] + 1) / 2) / g->n0, (b + (t[j] + 1) / 2) / g->n1, m->xyz + 3 * node);
        }
    }
}

static inline mesh lattice_mesh(const lattice *g)
{
    mesh m = {0};
    const shape quad = SHAPE_QUAD;
    const int nelem = g->n0 * g->n1;
    const int nnode = (g->n0 * g->order + !g->closed) * (g->n1 * g->order + 1);
    CHECK_OK(mesh_make(g->order, nnode, 1, &quad, &nelem, &m));
    for (int b = 0; b < g->n1; b++) {
        for (int a = 0; a < g->n0; a++) {
            lattice_element(g, a, b, &m);
        }
    }
    CHECK_OK(mesh_check(&m));
    return m;
}

static inline int one_material(double u, double v)
{
    (void)u;
    (void)v;
    return 0;
}

// the prototypes' section: outer radius 4 mm, inner 3.2 mm, stiff sector of full width `width`
// about `middle`
typedef struct prototype {
    outline item[2];
    section_outline all;
} prototype;

static inline void prototype_set(prototype *p, int count, double middle, double width)
{
    *p = (prototype){
        .item = {{.kind = KIND_ANNULUS, .material = 0, .outer = 4e-3, .inner = 3.2e-3},
                 {.kind = KIND_SECTOR,
                  .material = 1,
                  .outer = 4e-3,
                  .inner = 3.2e-3,
                  .mid_angle = middle,
                  .width = width}},
        .all = {.count = count,
                .size = 4e-3,
                .turn = count > 1 ? middle : 0,
                .has_symmetry = count > 1},
    };
    p->all.items = p->item;
}

static inline void prototype_materials(double nu_soft, double nu_stiff, material m[2])
{
    m[0] = (material){.name = "soft", .E = 0.66e6, .nu = nu_soft};
    m[1] = (material){.name = "stiff", .E = 15.93e6, .nu = nu_stiff};
}

static inline beam_law full_law(const section_outline *o, const material *materials, double size)
{
    beam_law law = {0};
    mesh m = {0};
    mesh_options options = mesh_options_default();
    options.size = size;
    CHECK_OK(section_mesh_make(o, &options, &m));
    CHECK_OK(section_full_mesh(&m, materials, &law, NULL));
    mesh_free(&m);
    return law;
}

static inline beam_centres centres_of(const beam_law *law)
{
    beam_centres c = {0};
    CHECK_OK(beam_law_centres(law, &c));
    return c;
}

// a stiffness written in N and mm, as the references are
static inline mat6 from_mm(mat6 k)
{
    for (int i = 0; i < 36; i++) {
        k.a[i / 6][i % 6] *= (i / 6 < 3 ? 1 : 1e-3) * (i % 6 < 3 ? 1 : 1e-3);
    }
    return k;
}
