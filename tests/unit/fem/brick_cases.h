// tests/unit/fem/brick_cases.h
// One plane element of each shape, skewed and bent, and bodies that stand on it.
#pragma once

#include "base/memory.h"
#include "fem/brick.h"
#include "tests/test.h"

#include <string.h>

enum { ISOTROPIC, STIFF, ORTHOTROPIC, GRADED, ALONG, MATERIALS };

static inline double across_modulus(const void *self, double x, double y, double s)
{
    (void)self;
    (void)s;
    return 2e6 * (1 + 100 * x + 50 * y);
}

// linear along s: the rules along a layer are exact for it
static inline double along_modulus(const void *self, double x, double y, double s)
{
    return across_modulus(self, x, y, s) * (1 + 200 * s);
}

static inline void make_materials(material *m)
{
    memset(m, 0, MATERIALS * sizeof *m);
    m[ISOTROPIC] = (material){.E = 0.66e6, .nu = 0.3, .density = 1200};
    m[STIFF] = (material){.E = 15.93e6, .nu = 0.4999};
    m[ORTHOTROPIC] = (material){.E1 = 10e6,
                                .E2 = 1e6,
                                .E3 = 2e6,
                                .G12 = 0.7e6,
                                .G13 = 0.5e6,
                                .G23 = 0.4e6,
                                .nu12 = 0.3,
                                .nu13 = 0.25,
                                .nu23 = 0.2,
                                .fibre_angle = 0.4,
                                .plane_angle = 0.3};
    m[GRADED] = (material){.E = 2e6, .nu = 0.4, .modulus = {.at = across_modulus, .across = true}};
    m[ALONG] = m[GRADED];
    m[ALONG].modulus.at = along_modulus;
    m[ALONG].modulus.along = true;
    for (int i = 0; i < MATERIALS; i++) {
        CHECK_OK(material_bind(&m[i]));
    }
}

// a place of the reference element, skewed, and bent where the order allows
static inline void skewed(const double *at, bool bent, double *x)
{
    const double u = at[0], v = at[1], b = bent ? 0.1 : 0;
    x[0] = 1e-3 * (2 + u + 0.2 * v + 0.1 * u * v + b * sin(2 * v) * (1 + u));
    x[1] = 1e-3 * (-1 - 0.15 * u + 1.1 * v - 0.12 * u * v + b * cos(1.5 * u) * v);
}

// one element of the shape; its frame is about a point outside
static inline void one_element(shape kind, int order, bool bent, mesh *m)
{
    const int one = 1;
    element e = {0};
    CHECK_OK(element_make(kind, order, &e));
    CHECK_OK(mesh_make(order, e.nnode, 1, &kind, &one, m));
    for (int i = 0; i < e.nnode; i++) {
        m->block[0].conn[i] = i;
        skewed(e.node[i], bent, m->xyz + 3 * i);
    }
    CHECK_OK(mesh_take_frames(m, 2));
    m->frame[0] = (material_frame){.polar = true, .centre = {-1e-3, 0.5e-3}};
    m->frame[0].axes = material_frame_make(0.2, 0.5).axes;
    m->frame[1] = material_frame_make(0.7, -0.3);
    CHECK_OK(mesh_check(m));
}

// where nodes of a level are: a twisted, tapered and bent bar
typedef struct bar {
    const mesh *plane;
    double twist, taper, bend; // [rad/m], [1/m], [1/m]
} bar;

static inline status bar_place(const void *self, double s, double *xyz, mat3 *axes,
                               double origin[3])
{
    const bar *b = (const bar *)self;
    const double k = b->bend, scale = 1 + b->taper * s;
    const mat3 turn = mat3_rot_z(b->twist * s);
    const mat3 lean = {{{cos(k * s), 0, sin(k * s)}, {0, 1, 0}, {-sin(k * s), 0, cos(k * s)}}};
    *axes = mat3_mul(lean, turn);
    origin[0] = k == 0 ? 0 : (1 - cos(k * s)) / k;
    origin[1] = 0;
    origin[2] = k == 0 ? s : sin(k * s) / k;
    for (int i = 0; i < b->plane->nnode; i++) {
        const double *from = b->plane->xyz + 3 * (size_t)i;
        const vec3 x = mat3_mul_vec(*axes, (vec3){{scale * from[0], scale * from[1], 0}});
        for (int d = 0; d < 3; d++) {
            xyz[3 * i + d] = origin[d] + x.a[d];
        }
    }
    return OK;
}
