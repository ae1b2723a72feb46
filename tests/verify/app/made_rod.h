// Shapes of the constant-offset prototype under one tendon with friction, by another route than
// rodsolver's: the classical section in closed form, each section's balance by fixed point, and the
// pose, the tension and the lengths marched from the base by Runge and Kutta's fourth order.
//
//   K (xi - xi*) = -T (t, r x t),  t = d / |d|,  d = v + w x r
//   T = T0 exp(-mu a),  a' = |w x t + t'|                  (the rope on a pulley, Euler and
//   Eytelwein)
//
// Made for tests; nothing here was measured.
#pragma once

#include "base/se3.h"

#include <math.h>

typedef struct made_section {
    double outer, inner, width;  // stiff sector about -x [m, rad]
    double E_soft, E_stiff, nu;  // [Pa]
    double EA, GA, GJ, EIx, EIy; // about the stiffness centre at (x_nc, 0)
    double x_nc;
} made_section;

typedef struct made_shape {
    double length;                           // of the unloaded rod [m]
    double radius, angle, tension, friction; // of the tendon at its place
    const made_section *section;
} made_shape;

enum { MADE_STEPS = 600 };

typedef struct made_point {
    double s, along; // of the unloaded rod, and as it lies [m]
    pose g;
} made_point;

// integrals of x and x^2, y^2 over the sector |angle| <= width/2 about +x, then turned to -x
static inline void made_section_fill(made_section *m)
{
    const double r2 = m->outer * m->outer - m->inner * m->inner;
    const double r3 = pow(m->outer, 3) - pow(m->inner, 3), r4 = pow(m->outer, 4) - pow(m->inner, 4);
    const double w = m->width, dE = m->E_stiff - m->E_soft;
    const double area = 3.14159265358979323846 * r2, second = 3.14159265358979323846 * r4 / 4;
    const double x = -2 * sin(w / 2) * r3 / 3;
    const double xx = (w + sin(w)) / 2 * r4 / 4, yy = (w - sin(w)) / 2 * r4 / 4;
    m->EA = m->E_soft * area + dE * w / 2 * r2;
    m->x_nc = dE * x / m->EA;
    m->EIx = m->E_soft * second + dE * yy;
    m->EIy = m->E_soft * second + dE * xx - m->EA * m->x_nc * m->x_nc;
    const double G = 1 / (2 * (1 + m->nu));
    m->GA = G * m->EA;
    m->GJ = G * (m->EIx + m->EIy);
}

static inline vec3 made_tangent(const made_shape *h, vec6 xi)
{
    const vec3 r = {{h->radius * cos(h->angle), h->radius * sin(h->angle), 0}};
    const vec3 d = vec3_add(vec6_linear(xi), vec3_cross(vec6_angular(xi), r));
    return vec3_scale(1 / vec3_norm(d), d);
}

// the strain at the geometric centre under the tension there
static inline vec6 made_strain(const made_shape *h, double tension, vec6 xi)
{
    const made_section *m = h->section;
    const vec3 nc = {{m->x_nc, 0, 0}};
    const vec3 r = {{h->radius * cos(h->angle), h->radius * sin(h->angle), 0}};
    for (int i = 0; i < 60; i++) {
        const vec3 n = vec3_scale(-tension, made_tangent(h, xi));
        const vec3 M = vec3_cross(vec3_sub(r, nc), n); // about the stiffness centre
        const vec3 w = {{M.a[0] / m->EIx, M.a[1] / m->EIy, M.a[2] / m->GJ}};
        const vec3 v = {{n.a[0] / m->GA, n.a[1] / m->GA, 1 + n.a[2] / m->EA}};
        const vec3 at = vec3_sub(v, vec3_cross(w, nc)); // of the geometric centre
        xi = (vec6){{at.a[0], at.a[1], at.a[2], w.a[0], w.a[1], w.a[2]}};
    }
    return xi;
}

// the angle that the tendon turns by per length: t' comes from the tension's own change, t' = dt/dT
// T'
static inline double made_turning(const made_shape *h, double tension, vec6 xi)
{
    const double step = 1e-4 * tension;
    const vec3 t = made_tangent(h, xi);
    const vec3 more = made_tangent(h, made_strain(h, tension + step, xi));
    const vec3 less = made_tangent(h, made_strain(h, tension - step, xi));
    const vec3 dt = vec3_scale(1 / (2 * step), vec3_sub(more, less));
    const vec3 wt = vec3_cross(vec6_angular(xi), t);
    double rate = vec3_norm(wt);
    for (int i = 0; i < 20; i++) {
        rate = vec3_norm(vec3_add_scaled(wt, -h->friction * tension * rate, dt));
    }
    return rate;
}

typedef struct made_rate {
    vec6 xi;
    double turning, stretch;
} made_rate;

static inline made_rate made_rates(const made_shape *h, double turned, vec6 near)
{
    made_rate k;
    const double tension = h->tension * exp(-h->friction * turned);
    k.xi = made_strain(h, tension, near);
    k.turning = tension > 0 ? made_turning(h, tension, k.xi) : 0;
    k.stretch = vec3_norm(vec6_linear(k.xi));
    return k;
}

// out [MADE_STEPS + 1]: the turning by Runge and Kutta, the pose by the mean strain of Simpson's
// rule with its first commutator (order 4)
static inline void made_march(const made_shape *h, made_point *out)
{
    const double ds = h->length / MADE_STEPS;
    double turned = 0;
    vec6 near = {{0, 0, 1, 0, 0, 0}};
    out[0] = (made_point){.g = pose_identity()};
    for (int i = 0; i < MADE_STEPS; i++) {
        const made_rate a = made_rates(h, turned, near);
        const made_rate b = made_rates(h, turned + ds / 2 * a.turning, a.xi);
        const made_rate c = made_rates(h, turned + ds / 2 * b.turning, b.xi);
        const made_rate d = made_rates(h, turned + ds * c.turning, c.xi);
        turned += ds / 6 * (a.turning + 2 * b.turning + 2 * c.turning + d.turning);
        const made_rate e = made_rates(h, turned, d.xi);
        vec6 mean = vec6_scale(ds / 6, vec6_add(vec6_add(a.xi, e.xi), vec6_scale(4, c.xi)));
        mean = vec6_sub(mean, vec6_scale(ds * ds / 12, se3_bracket(e.xi, a.xi)));
        out[i + 1] =
            (made_point){.s = (i + 1) * ds,
                         .along = out[i].along + ds / 6 * (a.stretch + 4 * c.stretch + e.stretch),
                         .g = pose_mul(out[i].g, se3_exp(mean))};
        near = e.xi;
    }
}
