// How the sections of tests/sections.h are drawn: isotropic, of edges and circles.
#pragma once

#include "base/material.h"
#include "tests/shapes.h"

#include <stdbool.h>

enum { SAMPLE_SHAPES = 8, SAMPLE_POINTS = 32, SAMPLE_MATERIALS = 3 };

typedef struct sample {
    const char *name;
    int nshape;
    shape_spec shape[SAMPLE_SHAPES];
    double points[SAMPLE_POINTS][2];
    int npoint;
    material material[SAMPLE_MATERIALS]; // not yet bound
    double turn_rate;                    // of the pattern [rad/m]
    bool in_short;                       // among the few of the tests
} sample;

static inline material isotropic(double E, double nu)
{
    return (material){.name = "m", .E = E, .nu = nu};
}

static inline void sample_add(sample *s, shape_spec shape)
{
    s->shape[s->nshape++] = shape;
}

static inline void sample_polygon(sample *s, int n, const double (*points)[2], int material)
{
    double *to = s->points[s->npoint];
    memcpy(to, points, (size_t)n * sizeof *points);
    s->npoint += n;
    sample_add(s, a_polygon(n, to, material));
}

static inline void sample_ring(sample *s, double outer, double inner)
{
    s->material[0] = isotropic(0.66e6, 0.3);
    sample_add(s, an_annulus(outer, inner, 0));
}

// the prototypes' ring with a stiff sector
static inline void sample_sector(sample *s, double width, double contrast, double nu_soft)
{
    s->material[0] = isotropic(0.66e6, nu_soft);
    s->material[1] = isotropic(0.66e6 * contrast, 0.3);
    sample_add(s, an_annulus(4e-3, 3.2e-3, 0));
    sample_add(s, a_sector(4e-3, 3.2e-3, PI, width, 1));
}

static inline void sample_box(sample *s, double width, double height, double angle, double nu)
{
    s->material[0] = isotropic(1e6, nu);
    sample_add(s, a_rectangle(width, height, angle, 0, 0, 0));
}

// T, U, I and channel, of walls
static inline void sample_walls(sample *s, int n, const double (*wall)[4])
{
    s->material[0] = isotropic(1e6, 0.3);
    for (int i = 0; i < n; i++) {
        sample_add(s, a_rectangle(wall[i][0], wall[i][1], 0, wall[i][2], wall[i][3], 0));
    }
}

static inline void sample_angle(sample *s)
{
    static const double L[6][2] = {{0, 0},       {6e-3, 0},     {6e-3, 1e-3},
                                   {1e-3, 1e-3}, {1e-3, 10e-3}, {0, 10e-3}};
    s->material[0] = isotropic(1e6, 0.3);
    sample_polygon(s, 6, L, 0);
}

static inline void sample_square_with_stiff_half(sample *s)
{
    s->material[0] = isotropic(1e6, 0.3);
    s->material[1] = isotropic(1e7, 0.3);
    sample_add(s, a_rectangle(10e-3, 10e-3, 0, 0, 0, 0));
    sample_add(s, a_rectangle(5e-3, 10e-3, 0, 2.5e-3, 0, 1));
}

static inline void sample_catheter(sample *s)
{
    s->material[0] = isotropic(12e6, 0.45);
    s->material[1] = isotropic(170e6, 0.4);
    sample_add(s, a_disc(2e-3, 0, 0, 0));
    sample_add(s, a_sector(2e-3, 0.9e-3, PI, PI / 3, 1));
    sample_add(s, a_disc(0.8e-3, 0.75e-3, 0, -1));
    sample_add(s, a_disc(0.2e-3, -0.3e-3, 0.95e-3, -1));
    sample_add(s, a_disc(0.2e-3, 0, 1.55e-3, -1));
    sample_add(s, a_disc(0.2e-3, 0, -1.55e-3, -1));
}

static inline void sample_quadrilateral_with_holes(sample *s)
{
    static const double outer[5][2] = {
        {-5e-3, -4e-3}, {6e-3, -3e-3}, {5e-3, 3e-3}, {0, 5e-3}, {-4e-3, 4e-3}};
    static const double hole[3][2] = {{-2e-3, -1e-3}, {1e-3, -1.5e-3}, {0, 1e-3}};
    s->material[0] = isotropic(1e6, 0.35);
    sample_polygon(s, 5, outer, 0);
    sample_polygon(s, 3, hole, -1);
    sample_add(s, a_disc(1e-3, 3e-3, 0, -1));
}

static inline void sample_hexagon(sample *s)
{
    double p[6][2];
    for (int i = 0; i < 6; i++) {
        p[i][0] = 5e-3 * cos(PI * i / 3);
        p[i][1] = 5e-3 * sin(PI * i / 3);
    }
    s->material[0] = isotropic(1e6, 0.3);
    sample_polygon(s, 6, (const double(*)[2])p, 0);
}

static inline void sample_discs(sample *s, double x, int inside, double contrast)
{
    s->material[0] = isotropic(1e6, 0.3);
    s->material[1] = isotropic(1e6 * contrast, 0.4);
    sample_add(s, a_disc(5e-3, 0, 0, 0));
    sample_add(s, a_disc(2e-3, x, 0, inside));
}

static inline void sample_core_and_shell(sample *s, double nu_core, double nu_shell)
{
    s->material[0] = isotropic(10e6, nu_shell);
    s->material[1] = isotropic(1e6, nu_core);
    sample_add(s, an_annulus(5e-3, 2e-3, 0));
    sample_add(s, an_annulus(4e-3, 2e-3, 1));
}

static inline void sample_moved(sample *s, double x)
{
    s->material[0] = isotropic(1e6, 0.3);
    sample_add(s, a_rectangle(4e-3, 2e-3, 0.4, x, 0, 0));
}

static inline void sample_three_materials(sample *s)
{
    s->material[0] = isotropic(1e6, 0.3);
    s->material[1] = isotropic(5e6, 0.4);
    s->material[2] = isotropic(50e6, 0.2);
    sample_add(s, an_annulus(6e-3, 3e-3, 0));
    sample_add(s, a_sector(6e-3, 4e-3, 0.3, 1.2, 1));
    sample_add(s, a_sector(5e-3, 3e-3, 3.0, 0.8, 2));
}

static inline void sample_split_rectangle(sample *s)
{
    s->material[0] = isotropic(1e6, 0.0);
    s->material[1] = isotropic(3e6, 0.45);
    sample_add(s, a_rectangle(12e-3, 2e-3, 0, 0, -1e-3, 0));
    sample_add(s, a_rectangle(12e-3, 2e-3, 0, 0, 1e-3, 1));
}
