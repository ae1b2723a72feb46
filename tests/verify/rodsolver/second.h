// tests/verify/rodsolver/second.h
// A rod with everything on it, solved by ours and held against the second method.
#pragma once

#include "tests/rod_shooting_tendons.h"
#include "tests/unit/rodsolver/prototypes.h"

enum { TENDONS = 5 };

static const double ours_tolerance = 1e-10; // |p - p_exact| / L
static const double apart = 1e-10;          // between the two methods' tips [m]: ten times that

typedef struct sample {
    law_along law;
    tendon_spec tendon[TENDONS];
    double tension[TENDONS], pull[TENDONS];
    rod_spec spec;
    rod_request rq;
    int steps; // of the second method
} sample;

static inline double wave(const void *expression, double s)
{
    const double *c = expression; // mean, height, rate
    return c[0] + c[1] * sin(c[2] * s);
}

static inline field waves(const double *c)
{
    return (field){.at = wave, .expression = c};
}

static inline void sample_make(prototype p, int ntendon, sample *out)
{
    *out = (sample){.steps = 24, .tension = {0.3, 0.2, 0.25, 0.1, 0.15}};
    p.angle[0] += 0.3;
    prototype_law(&p, &out->law);
    for (int i = 0; i < TENDONS; i++) {
        out->tendon[i] = straight_tendon("t", 3.6e-3, 2 * PROTOTYPE_PI * i / TENDONS);
    }
    out->spec = (rod_spec){.law = &out->law, .ntendon = ntendon, .tendons = out->tendon};
    out->rq = (rod_request){.tension = out->tension, .cold = true};
}

typedef struct ours {
    rod *r;
    rod_state *state;
    double length[TENDONS], tension[TENDONS];
    rod_solution out;
} ours;

static inline bool ours_solve(const sample *q, ours *o)
{
    const rod_options options = {.tolerance = ours_tolerance};
    *o = (ours){.out = {.tendon_length = o->length, .tension = o->tension}};
    CHECK_OK(rod_make(&q->spec, &options, &o->r));
    if (o->r) {
        CHECK_OK(rod_state_make(o->r, &o->state));
    }
    if (!o->state) {
        return false;
    }
    const status st = rod_solve(o->state, &q->rq, &o->out);
    CHECK_OK(st);
    return st == OK;
}

static inline void ours_free(ours *o)
{
    rod_state_free(o->state);
    rod_free(o->r);
}

static inline void compare(const char *what, const sample *q, const ours *o, const shoot_answer *a)
{
    const double L = q->law.length, tips = distance(o->out.tip.p, a->tip.p);
    printf("%-44s tips %.1e m apart, own estimates %.1e and %.1e m, moved %.3f L\n", what, tips,
           o->out.relative_error * L, a->error, distance(a->tip.p, (vec3){{0, 0, L}}) / L);
    CHECK(a->solved);
    CHECK_WITHIN(tips, 0, apart);
    CHECK_WITHIN(rotation_difference(o->out.tip.R, a->tip.R), 0, apart / L * 10);
    for (int i = 0; i < q->spec.ntendon; i++) {
        CHECK_WITHIN(o->length[i], a->length[i], apart);
    }
}
