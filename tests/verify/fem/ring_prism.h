// tests/verify/fem/ring_prism.h
// A prism on a ring mesh, solved by doubling.
#pragma once

#include "tests/verify/fem/ring_mesh.h"

static const material SOFT_AND_STIFF[2] = {{.name = "soft", .E = 0.66e6, .nu = 0.3},
                                           {.name = "stiff", .E = 15.93e6, .nu = 0.3}};

typedef struct prism {
    mesh plane;
    body body;
    segment_problem problem;
    way_wants wants;
    way_run run;
} prism;

static inline void prism_free(prism *p)
{
    way_run_free(&p->run);
    body_free(&p->body);
    mesh_free(&p->plane);
    *p = (prism){0};
}

// p must stay where it is
static inline void prism_make(const ring *s, const material *materials, int order, int layers,
                              double length, double turn_rate, int base, int tip, prism *p)
{
    CHECK_OK(ring_mesh(s, &p->plane));
    CHECK_OK(prism_body(&p->plane, materials, order, layers, length, turn_rate, &p->body));
    p->problem = (segment_problem){.body = &p->body, .base = base, .tip = tip};
    p->wants = (way_wants){.middle = length / 2, .middle_half = length / 8};
}

static inline void prism_solve(const ring *s, const material *materials, int order, int layers,
                               double length, double turn_rate, int base, int tip, prism *p)
{
    prism_make(s, materials, order, layers, length, turn_rate, base, tip, p);
    CHECK_OK(way_doubling(&p->problem, &p->wants, &p->run));
}
