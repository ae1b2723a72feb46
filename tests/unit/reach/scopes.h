// tests/unit/reach/scopes.h
// Scopes to test with: constant curvature, the prototypes, and one like the paper's
// neuro-endoscope.
#pragma once

#include "reach/scope.h"
#include "tests/unit/rodsolver/prototypes.h"

typedef struct made_scope {
    law_along law;
    rod *rod;
    scope scope;
} made_scope;

// one fine plan for all tensions: differences see no jumps between plans
static const rod_options one_plan = {.npanel = 64};
// as a case has it
static const rod_options usual_plan = {.tolerance = 1e-9};

// 20 mm, bent up to 270 degrees
static inline made_scope arc_scope(void)
{
    return (made_scope){.scope = {.name = "arc",
                                  .length = 0.02,
                                  .radius = 1e-3,
                                  .njoint = 3,
                                  .low = {0, -PROTOTYPE_PI, 0},
                                  .high = {0.1, PROTOTYPE_PI, 1.5 * PROTOTYPE_PI}}};
}

static inline void free_scope(made_scope *m)
{
    rod_free(m->rod);
    law_along_free(&m->law);
}

// a rod of this pattern with straight tendons at these angles, each pulled up to `most` [N]
static inline void rod_scope(const prototype *p, int n, const double *angle, double radius,
                             double most, rod_options options, made_scope *m)
{
    tendon_spec tendon[SCOPE_TENDONS];
    *m = (made_scope){.scope = {.name = "rod",
                                .length = p->length,
                                .radius = p->outer,
                                .njoint = SCOPE_BEND + n,
                                .low = {0, -PROTOTYPE_PI, 0},
                                .high = {0.1, PROTOTYPE_PI}}};
    prototype_law(p, &m->law);
    for (int i = 0; i < n; i++) {
        tendon[i] = straight_tendon(NULL, radius, angle[i]);
        m->scope.high[SCOPE_BEND + i] = most;
    }
    const rod_spec spec = {.law = &m->law, .ntendon = n, .tendons = tendon};
    CHECK_OK(rod_make(&spec, &options, &m->rod));
    m->scope.rod = m->rod;
}

// the paper's helical prototype with one tendon
static inline void helical_scope(rod_options options, made_scope *m)
{
    const prototype p = helical_nc();
    rod_scope(&p, 1, (const double[]){PROTOTYPE_PI / 2}, 3.6e-3, 1.5, options, m);
}

static inline void constant_scope(int n, rod_options options, made_scope *m)
{
    const prototype p = constant_nc();
    rod_scope(&p, n, (const double[]){0, PROTOTYPE_PI, PROTOTYPE_PI / 2}, 3.6e-3, 0.98, options, m);
}

// half a turn of the stiff half, the tendon at the centre: bent by the law's own offset
static inline void neuro_scope(int n, rod_options options, made_scope *m)
{
    const prototype p = {0.03,
                         1.5e-3,
                         1.1e-3,
                         0.66e6,
                         15.93e6,
                         0.45,
                         {PROTOTYPE_PI, 0},
                         {PROTOTYPE_PI / 2, PROTOTYPE_PI / 2}};
    rod_scope(&p, n, (const double[]){0, PROTOTYPE_PI / 2, PROTOTYPE_PI}, n == 1 ? 0 : 1.2e-3,
              n == 1 ? 2 : 0.5, options, m);
}

// an entry line like no axis
static inline pose slanted_entry(void)
{
    return (pose){so3_exp((vec3){{0.3, -0.8, 0.5}}), {{0.01, -0.02, 0.03}}};
}

// a repeatable number in [low, high)
static inline double random_between(unsigned long long *seed, double low, double high)
{
    *seed = *seed * 6364136223846793005ull + 1442695040888963407ull;
    return low + (high - low) * (double)(*seed >> 11) / 9007199254740992.0;
}

static inline void random_joints(const scope *s, unsigned long long *seed, double *q)
{
    for (int i = 0; i < s->njoint; i++) {
        q[i] = random_between(seed, s->low[i], s->high[i]);
    }
}
