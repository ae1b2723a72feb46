// tests/shapes.h
// Shapes as tests draw them, in m, and integrals over their meshes.
#pragma once

#include "base/element.h"
#include "base/mesh.h"
#include "meshes/mesher.h"
#include "meshes/outline.h"

#include "meshes/edges.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define PI 3.14159265358979323846

static inline field fixed(double value)
{
    return field_constant(value);
}

static inline shape_spec an_annulus(double outer, double inner, int material)
{
    shape_spec s = {.at = {1, 1}, .material_index = material};
    s.annulus =
        (ring_spec){.at = {1, 1}, .outer_radius = fixed(outer), .inner_radius = fixed(inner)};
    return s;
}

static inline shape_spec a_sector(double outer, double inner, double mid, double width,
                                  int material)
{
    shape_spec s = {.at = {1, 1}, .material_index = material};
    s.sector = (ring_spec){.at = {1, 1},
                           .outer_radius = fixed(outer),
                           .inner_radius = fixed(inner),
                           .mid_angle = fixed(mid),
                           .width = fixed(width)};
    return s;
}

static inline shape_spec a_disc(double radius, double x, double y, int material)
{
    shape_spec s = {.at = {1, 1}, .material_index = material};
    s.disc = (disc_spec){.at = {1, 1}, .radius = fixed(radius), .centre = {fixed(x), fixed(y)}};
    return s;
}

static inline shape_spec a_rectangle(double width, double height, double angle, double x, double y,
                                     int material)
{
    shape_spec s = {.at = {1, 1}, .material_index = material};
    s.rectangle = (rectangle_spec){.at = {1, 1},
                                   .width = fixed(width),
                                   .height = fixed(height),
                                   .angle = fixed(angle),
                                   .centre = {fixed(x), fixed(y)}};
    return s;
}

// points: [n][2], kept by the caller
static inline shape_spec a_polygon(int n, const double *points, int material)
{
    shape_spec s = {.at = {1, 1}, .material_index = material};
    s.polygon = (polygon_spec){.at = {1, 1},
                               .points = {.nrow = n, .ncol = 2, .a = (double *)(size_t)points}};
    return s;
}

static inline shape_spec an_ellipse(double a, double b, double angle, double x, double y,
                                    int material)
{
    shape_spec s = {.at = {1, 1}, .material_index = material};
    s.ellipse = (ellipse_spec){.at = {1, 1},
                               .semi_axis_x = fixed(a),
                               .semi_axis_y = fixed(b),
                               .angle = fixed(angle),
                               .centre = {fixed(x), fixed(y)}};
    return s;
}

static inline shape_spec a_rounded_rectangle(double width, double height, double radius,
                                             double angle, int material)
{
    shape_spec s = {.at = {1, 1}, .material_index = material};
    s.rounded_rectangle = (rounded_spec){.at = {1, 1},
                                         .width = fixed(width),
                                         .height = fixed(height),
                                         .corner_radius = fixed(radius),
                                         .angle = fixed(angle)};
    return s;
}

// points: [n][2], kept by the caller
static inline shape_spec a_spline(int n, const double *points, int material)
{
    shape_spec s = {.at = {1, 1}, .material_index = material};
    s.spline = (polygon_spec){.at = {1, 1},
                              .points = {.nrow = n, .ncol = 2, .a = (double *)(size_t)points}};
    return s;
}

static inline shape_spec lumens_on_a_circle(double radius, int count, double circle, double first,
                                            int material)
{
    shape_spec s = {.at = {1, 1}, .material_index = material};
    s.lumens = (lumens_spec){.at = {1, 1},
                             .radius = fixed(radius),
                             .count = count,
                             .circle_radius = fixed(circle),
                             .first_angle = fixed(first)};
    return s;
}

static inline shape_spec in_array(shape_spec s, int count, double first, bool turn)
{
    s.array = (array_spec){.at = {1, 1}, .count = count, .first_angle = fixed(first), .turn = turn};
    return s;
}

static inline status mesh_of(int n, const shape_spec *shapes, int kind, int order, double size,
                             mesh *out)
{
    section_outline o = {0};
    const mesh_options options = {.kind = kind, .order = order, .size = size};
    status st = shapes_at((shape_list){.count = n, .items = shapes}, 0, &o);
    if (st == OK) {
        st = section_mesh_make(&o, &options, out);
    }
    section_outline_free(&o);
    return st;
}

// int of 1, x, y, x^2, y^2, x y over the elements of a material (-1: of all)
typedef struct moments {
    double a[6];
} moments;

static inline moments mesh_moments(const mesh *m, int material)
{
    moments sum = {0};
    const mesh_block *b = &m->block[0];
    element e = {0};
    basis_table t = {0};
    if (element_make(b->shape, m->order, &e) != OK ||
        basis_table_make(&e, 4 * m->order, &t) != OK) {
        return sum;
    }
    for (int k = 0; k < b->nelem; k++) {
        for (int q = 0; q < t.npoint && (material < 0 || b->material[k] == material); q++) {
            double x[2] = {0}, J[2][2] = {{0}};
            for (int i = 0; i < t.nnode; i++) {
                const double *p = m->xyz + 3 * (size_t)b->conn[k * t.nnode + i];
                for (int d = 0; d < 2; d++) {
                    x[d] += t.N[q * t.nnode + i] * p[d];
                    J[d][0] += t.dN[2 * (q * t.nnode + i)] * p[d];
                    J[d][1] += t.dN[2 * (q * t.nnode + i) + 1] * p[d];
                }
            }
            const double w = t.weight[q] * (J[0][0] * J[1][1] - J[0][1] * J[1][0]);
            const double f[6] = {1, x[0], x[1], x[0] * x[0], x[1] * x[1], x[0] * x[1]};
            for (int i = 0; i < 6; i++) {
                sum.a[i] += w * f[i];
            }
        }
    }
    basis_table_free(&t);
    return sum;
}

// No two nodes at one place, no edge with more than two elements, and as many edges on the boundary
// as corners there.
static inline bool mesh_is_conforming(const mesh *m)
{
    edge_list e = {0};
    int nside = 0, *corner = NULL, *on_boundary = NULL;
    bool good = mesh_corners(m, &nside, &corner) == OK &&
                edge_list_make(mesh_element_count(m), nside, corner, &e) == OK;
    on_boundary = calloc((size_t)m->nnode, sizeof *on_boundary);
    for (int i = 0; good && i < e.nedge; i++) {
        good = e.count[i] == 1 || e.count[i] == 2;
        for (int k = 0; k < 2 && e.count[i] == 1; k++) {
            on_boundary[e.end[i][k]]++;
        }
    }
    double size = 0;
    for (int i = 0; i < 3 * m->nnode; i++) {
        size = fmax(size, fabs(m->xyz[i]));
    }
    for (int i = 0; good && i < m->nnode; i++) {
        good = on_boundary[i] % 2 == 0;
        for (int k = 0; good && k < i; k++) {
            const double *x = m->xyz + 3 * i, *y = m->xyz + 3 * k;
            good = fabs(x[0] - y[0]) + fabs(x[1] - y[1]) > 1e-9 * size;
        }
    }
    free(on_boundary);
    free(corner);
    edge_list_free(&e);
    return good;
}

// length of all element edges that only one element has, as chords
static inline double mesh_boundary_length(const mesh *m)
{
    edge_list e = {0};
    int nside = 0, *corner = NULL;
    double sum = 0;
    if (mesh_corners(m, &nside, &corner) == OK &&
        edge_list_make(mesh_element_count(m), nside, corner, &e) == OK) {
        for (int i = 0; i < e.nedge; i++) {
            const double *x = m->xyz + 3 * e.end[i][0], *y = m->xyz + 3 * e.end[i][1];
            sum += e.count[i] == 1 ? hypot(x[0] - y[0], x[1] - y[1]) : 0;
        }
    }
    free(corner);
    edge_list_free(&e);
    return sum;
}
