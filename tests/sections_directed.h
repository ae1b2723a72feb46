// How the sections of tests/sections.h are drawn: outlines of curves, directed materials, patterns
// that turn.
#pragma once

#include "tests/sections_made.h"

// --- outlines of curves

static inline void sample_ellipse(sample *s)
{
    s->material[0] = isotropic(1e6, 0.3);
    sample_add(s, an_ellipse(5e-3, 2e-3, 0.4, 0, 0, 0));
}

static inline void sample_ellipse_with_core(sample *s)
{
    s->material[0] = isotropic(1e6, 0.45);
    s->material[1] = isotropic(2e7, 0.3);
    sample_add(s, an_ellipse(6e-3, 3e-3, 0, 0, 0, 0));
    sample_add(s, an_ellipse(2e-3, 1e-3, 0.8, 2e-3, 0.3e-3, 1));
    sample_add(s, an_ellipse(1.5e-3, 0.8e-3, -0.5, -2.5e-3, 0, -1));
}

static inline void sample_rounded(sample *s)
{
    s->material[0] = isotropic(1e6, 0.3);
    sample_add(s, a_rounded_rectangle(8e-3, 4e-3, 1e-3, 0, 0));
}

static inline void sample_rounded_with_lumens(sample *s)
{
    s->material[0] = isotropic(1e6, 0.4);
    sample_add(s, a_rounded_rectangle(6e-3, 6e-3, 0.3e-3, 0.2, 0));
    sample_add(s, lumens_on_a_circle(0.5e-3, 3, 1.8e-3, 0.5, -1));
}

static inline void sample_spline(sample *s)
{
    static const double bean[8][2] = {{5e-3, 0},     {3.5e-3, 2.5e-3}, {0, 2e-3},
                                      {-3e-3, 3e-3}, {-5e-3, 0.5e-3},  {-3e-3, -2.5e-3},
                                      {0, -1.2e-3},  {3.5e-3, -2.5e-3}};
    s->material[0] = isotropic(1e6, 0.35);
    memcpy(s->points, bean, sizeof bean);
    sample_add(s, a_spline(8, s->points[0], 0));
    sample_add(s, a_disc(0.6e-3, -3e-3, 0.5e-3, -1));
}

// --- directed materials

static inline material ply(double plane_angle, double fibre_angle)
{
    return (material){.name = "ply",
                      .E1 = 20e6,
                      .E2 = 1.4e6,
                      .E3 = 1.2e6,
                      .G12 = 0.9e6,
                      .G13 = 0.8e6,
                      .G23 = 0.5e6,
                      .nu12 = 0.42,
                      .nu13 = 0.35,
                      .nu23 = 0.3,
                      .plane_angle = plane_angle,
                      .fibre_angle = fibre_angle};
}

// everything is coupled
static inline material anisotropic(void)
{
    static const double Q[6][6] = {
        {24e6, 3e6, 2e6, 0.5e6, 3e6, -1e6},     {3e6, 6e6, 2e6, 0.6e6, 0.4e6, 0.3e6},
        {2e6, 2e6, 5e6, -0.4e6, 0.2e6, 0.5e6},  {0.5e6, 0.6e6, -0.4e6, 2e6, 0.1e6, 0.2e6},
        {3e6, 0.4e6, 0.2e6, 0.1e6, 4e6, 0.3e6}, {-1e6, 0.3e6, 0.5e6, 0.2e6, 0.3e6, 3e6}};
    return (material){.name = "anisotropic",
                      .stiffness = {.nrow = 6, .ncol = 6, .a = (double *)(size_t)Q}};
}

// a shape whose material's axes go around it, its fibre turned from the rod's axis
static inline shape_spec wound(shape_spec shape, double fibre_angle)
{
    shape.axes = SHAPE_AXES_TANGENT;
    shape.fibre_angle = fixed(fibre_angle);
    return shape;
}

static inline void sample_square_of_plies(sample *s)
{
    s->material[0] = ply(0, PI / 8);
    sample_add(s, a_rectangle(5e-3, 5e-3, 0, 0, 0, 0));
}

static inline void sample_wound_ring(sample *s)
{
    s->material[0] = ply(0, 0);
    sample_add(s, wound(an_annulus(4e-3, 3.2e-3, 0), 0.5));
}

static inline void sample_wound_wall(sample *s)
{
    s->material[0] = ply(0, 0);
    sample_add(s, wound(an_annulus(4e-3, 3.2e-3, 0), PI / 4));
    sample_add(s, wound(an_annulus(3.6e-3, 3.2e-3, 0), -PI / 4));
}

static inline void sample_laminate(sample *s)
{
    s->material[0] = ply(0, PI / 4);
    s->material[1] = ply(0, -PI / 4);
    sample_add(s, a_rectangle(8e-3, 1e-3, 0, 0, -0.5e-3, 0));
    sample_add(s, a_rectangle(8e-3, 1e-3, 0, 0, 0.5e-3, 1));
}

static inline void sample_anisotropic_half(sample *s)
{
    s->material[0] = isotropic(1e6, 0.45);
    s->material[1] = anisotropic();
    sample_add(s, a_rectangle(6e-3, 4e-3, 0, 0, 0, 0));
    sample_add(s, a_rectangle(3e-3, 4e-3, 0, 1.5e-3, 0, 1));
}

static inline void sample_wound_ring_with_sector(sample *s)
{
    s->material[0] = isotropic(0.66e6, 0.45);
    s->material[1] = ply(0, 0);
    sample_add(s, an_annulus(4e-3, 3.2e-3, 0));
    sample_add(s, wound(a_sector(4e-3, 3.2e-3, PI, PI / 4, 1), 0.4));
}

// --- patterns that turn along the rod

static inline void sample_turning_sector(sample *s, double nu_soft, double turn_rate)
{
    sample_sector(s, PI / 8, 24.136, nu_soft);
    s->turn_rate = turn_rate;
}

static inline void sample_turning_box(sample *s, double width, double height, double turn_rate)
{
    sample_box(s, width, height, 0, 0.3);
    s->turn_rate = turn_rate;
}

static inline void sample_turning_catheter(sample *s, double turn_rate)
{
    sample_catheter(s);
    s->turn_rate = turn_rate;
}
