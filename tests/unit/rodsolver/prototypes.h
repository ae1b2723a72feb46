// tests/unit/rodsolver/prototypes.h
// The paper's prototypes with the classical section, by closed forms: what the tests of the rod
// start from.
#pragma once

#include "rodsolver/rod.h"
#include "tests/test.h"

#define PROTOTYPE_PI 3.14159265358979323846

typedef struct prototype {
    double length, outer, inner; // [m]
    double soft, stiff, nu;      // [Pa, Pa, -]
    double angle[2], width[2];   // of the stiff sector at s = 0 and s = L, linear between [rad]
} prototype;

static inline prototype constant_nc(void)
{
    return (prototype){0.12,
                       4e-3,
                       3.2e-3,
                       0.66e6,
                       15.93e6,
                       0.45,
                       {PROTOTYPE_PI, PROTOTYPE_PI},
                       {PROTOTYPE_PI / 8, PROTOTYPE_PI / 8}};
}

static inline prototype helical_nc(void)
{
    prototype p = constant_nc();
    p.angle[0] = 0;
    p.width[0] = PROTOTYPE_PI / 4;
    return p;
}

static inline prototype homogeneous_tube(void)
{
    prototype p = constant_nc();
    p.angle[0] = p.angle[1] = 0;
    p.stiff = p.soft;
    return p;
}

// the integrals of E over annulus and sector, in the frame whose x axis is the sector's middle
typedef struct prototype_section {
    double EA, x, EIx, EIy, GJ; // EIx, EIy about the stiffness centre (x, 0)
} prototype_section;

static inline prototype_section prototype_integrals(const prototype *p, double width)
{
    const double o = p->outer, i = p->inner, half = sin(width / 2);
    const double area = (o * o - i * i) / 2, first = (o * o * o - i * i * i) / 3;
    const double second = (o * o * o * o - i * i * i * i) / 4;
    const double xx = (width + sin(width)) / 2, yy = (width - sin(width)) / 2;
    const double EA = area * (p->soft * (2 * PROTOTYPE_PI - width) + p->stiff * width);
    const double ES = first * 2 * half * (p->stiff - p->soft);
    const double x = ES / EA;
    const double EIy = second * (p->soft * (PROTOTYPE_PI - xx) + p->stiff * xx) - EA * x * x;
    const double EIx = second * (p->soft * (PROTOTYPE_PI - yy) + p->stiff * yy);
    return (prototype_section){EA, x, EIx, EIy, (EIx + EIy) / (2 * (1 + p->nu))};
}

// classical K about the geometric centre in the sector's frame
static inline mat6 prototype_stiffness(const prototype *p, double width)
{
    const prototype_section q = prototype_integrals(p, width);
    const double GA = q.EA / (2 * (1 + p->nu));
    const double diagonal[6] = {GA, GA, q.EA, q.EIx, q.EIy, q.GJ};
    mat6 K = {0};
    for (int i = 0; i < 6; i++) {
        K.a[i][i] = diagonal[i];
    }
    return beam_law_move(K, -q.x, 0, 0);
}

static inline void prototype_law(const prototype *p, law_along *out)
{
    const bool varies = p->angle[0] != p->angle[1] || p->width[0] != p->width[1];
    CHECK_OK(law_along_make(p->length, 1, varies ? 25 : 1, out));
    for (int i = 0; i < out->nnode; i++) {
        const double t = law_along_node(out, 0, i) / p->length;
        out->law[i].K = prototype_stiffness(p, p->width[0] + (p->width[1] - p->width[0]) * t);
        out->turn[i] = p->angle[0] + (p->angle[1] - p->angle[0]) * t;
    }
}

static inline tendon_spec straight_tendon(const char *name, double radius, double angle)
{
    return (tendon_spec){
        .name = name, .radius = field_constant(radius), .angle = field_constant(angle)};
}

// a rod and one state of it
typedef struct made_rod {
    rod *rod;
    rod_state *state; // NULL where the rod could not be made
} made_rod;

static inline made_rod make_rod(const law_along *law, int ntendon, const tendon_spec *tendons,
                                rod_options options)
{
    made_rod m = {0};
    const rod_spec spec = {.law = law, .ntendon = ntendon, .tendons = tendons};
    CHECK_OK(rod_make(&spec, &options, &m.rod));
    if (m.rod) {
        CHECK_OK(rod_state_make(m.rod, &m.state));
    }
    return m;
}

static inline void free_rod(made_rod m)
{
    rod_state_free(m.state);
    rod_free(m.rod);
}

// tensions alone, from rest
static inline status solve_tensions(rod_state *state, const double *tension, rod_solution *out)
{
    return rod_solve(state, &(rod_request){.tension = tension, .cold = true}, out);
}

// a rod, solved for one row of tensions; the caller frees it
static inline made_rod solved_rod(const law_along *law, int ntendon, const tendon_spec *tendons,
                                  rod_options options, const double *tension, rod_solution *out)
{
    const made_rod m = make_rod(law, ntendon, tendons, options);
    if (m.state) {
        CHECK_OK(solve_tensions(m.state, tension, out));
    }
    return m;
}

static inline double distance(vec3 p, vec3 q)
{
    return vec3_norm(vec3_sub(p, q));
}

static inline double rotation_difference(mat3 a, mat3 b)
{
    double worst = 0;
    for (int i = 0; i < 9; i++) {
        worst = fmax(worst, fabs(a.a[i / 3][i % 3] - b.a[i / 3][i % 3]));
    }
    return worst;
}
