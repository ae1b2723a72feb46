// tests/verify/fem/bad_mesh.h
// A bad plane mesh, skewed quads and triangles of two materials with one Poisson's ratio, and the
// exact fields of a segment on it whose base is free to contract.
#pragma once

#include "base/material.h"
#include "base/mesh.h"
#include "tests/test.h"

static const material bad_materials[2] = {{.E = 0.66e6, .nu = 0.4}, {.E = 15.93e6, .nu = 0.4}};

enum { VERTICES = 9, QUADS = 3, TRIANGLES = 2 };

static const double vertex[VERTICES][2] = {{0, 0},         {1e-3, -2e-4},    {3e-3, 1e-4},
                                           {-3e-4, 2e-3},  {1.9e-3, 1.2e-3}, {2.5e-3, 1.6e-3},
                                           {2e-4, 2.8e-3}, {1.1e-3, 3.3e-3}, {3.2e-3, 3e-3}};
static const int quad_corner[QUADS][4] = {{0, 1, 3, 4}, {1, 2, 4, 5}, {3, 4, 6, 7}};
static const int triangle_corner[TRIANGLES][3] = {{4, 5, 8}, {4, 8, 7}};
static const int quad_material[QUADS] = {0, 1, 1};
static const int triangle_material[TRIANGLES] = {0, 1};

static inline int find_or_add(mesh *m, const double *x)
{
    for (int i = 0; i < m->nnode; i++) {
        if (hypot(m->xyz[3 * i] - x[0], m->xyz[3 * i + 1] - x[1]) < 1e-9) {
            return i;
        }
    }
    m->xyz[3 * m->nnode] = x[0];
    m->xyz[3 * m->nnode + 1] = x[1];
    return m->nnode++;
}

// straight edges: the geometry is that of the corners' own order-1 element
static inline void place(mesh *m, int block, int e, const int *corner)
{
    element fine = {0}, coarse = {0};
    const mesh_block *b = &m->block[block];
    CHECK_OK(element_make(b->shape, m->order, &fine));
    CHECK_OK(element_make(b->shape, 1, &coarse));
    for (int i = 0; i < fine.nnode; i++) {
        double N[4], x[2] = {0};
        element_basis(&coarse, fine.node[i], N, NULL);
        for (int k = 0; k < coarse.nnode; k++) {
            x[0] += N[k] * vertex[corner[k]][0];
            x[1] += N[k] * vertex[corner[k]][1];
        }
        b->conn[e * b->per_elem + i] = find_or_add(m, x);
    }
}

static inline void bad_mesh(int order, mesh *m)
{
    const shape shapes[2] = {SHAPE_QUAD, SHAPE_TRIANGLE};
    const int nelem[2] = {QUADS, TRIANGLES};
    CHECK_OK(mesh_make(order, 5 * ELEMENT_MAX_PLANE_NODES, 2, shapes, nelem, m));
    m->nnode = 0;
    for (int e = 0; e < QUADS; e++) {
        place(m, 0, e, quad_corner[e]);
        m->block[0].material[e] = quad_material[e];
    }
    for (int e = 0; e < TRIANGLES; e++) {
        place(m, 1, e, triangle_corner[e]);
        m->block[1].material[e] = triangle_material[e];
    }
}

// int E (1, x, y, x^2, xy, y^2) over the polygons: triangles by their edges' middles, exact to
// degree 2
static inline void add_triangle(const double *a, const double *b, const double *c, double E,
                                double *s)
{
    const double area = ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;
    const double *p[4] = {a, b, c, a};
    for (int i = 0; i < 3; i++) {
        const double x = (p[i][0] + p[i + 1][0]) / 2, y = (p[i][1] + p[i + 1][1]) / 2;
        const double part[6] = {1, x, y, x * x, x * y, y * y};
        for (int k = 0; k < 6; k++) {
            s[k] += E * area / 3 * part[k];
        }
    }
}

static inline void stiffness_integrals(double *s)
{
    for (int e = 0; e < QUADS; e++) {
        const int *q = quad_corner[e];
        const double E = bad_materials[quad_material[e]].E;
        add_triangle(vertex[q[0]], vertex[q[1]], vertex[q[3]], E, s);
        add_triangle(vertex[q[0]], vertex[q[3]], vertex[q[2]], E, s);
    }
    for (int e = 0; e < TRIANGLES; e++) {
        const int *t = triangle_corner[e];
        add_triangle(vertex[t[0]], vertex[t[1]], vertex[t[2]],
                     bad_materials[triangle_material[e]].E, s);
    }
}

// eps_zz = a + b x + c y
typedef struct strain {
    double a, b, c;
} strain;

static inline void exact_displacement(strain e, double x, double y, double z, double *u)
{
    const double nu = bad_materials[0].nu;
    u[0] = -nu * (e.a * x + e.c * x * y) - e.b * (z * z + nu * (x * x - y * y)) / 2;
    u[1] = -nu * (e.a * y + e.b * x * y) - e.c * (z * z + nu * (y * y - x * x)) / 2;
    u[2] = (e.a + e.b * x + e.c * y) * z;
}
