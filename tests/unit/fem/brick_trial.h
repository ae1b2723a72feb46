// tests/unit/fem/brick_trial.h
// Many bodies of two layers on one element, and their stiffness.
#pragma once

#include "tests/unit/fem/brick_cases.h"

static const double layers[3] = {0, 0.8e-3, 2e-3};
static const bar straight = {0}, curved = {.twist = 300, .taper = 60, .bend = 80};

typedef struct trial {
    shape kind;
    int order, along, material, frame;
    bool bent, mixed;
} trial;

// body of two layers on one element; how NULL: a prism
static inline void stand(const trial *t, const material *materials, mesh *m, bar *how, body *b)
{
    one_element(t->kind, t->order, t->bent, m);
    m->block[0].material[0] = t->material;
    m->block[0].frame[0] = t->frame;
    body_spec spec = {.plane = m,
                      .materials = materials,
                      .order = t->along,
                      .nlayer = 2,
                      .layer = layers,
                      .mixed = t->mixed};
    if (how) {
        how->plane = m;
        spec.shape = (body_shape){.self = how, .place = bar_place};
    }
    CHECK_OK(body_make(&spec, b));
}

static inline double *stiffness(const body *b, int layer, int *n3)
{
    brick *w = NULL;
    double *K = NULL;
    *n3 = 3 * b->plane->block[0].per_elem * (b->order + 1);
    CHECK_OK(TAKE(K, (size_t)(*n3 * *n3)));
    CHECK_OK(brick_make(b, &w));
    CHECK_OK(brick_stand_on(w, 0, 0));
    CHECK_OK(brick_stiffness(w, layer, K));
    brick_free(w);
    return K;
}

static inline double largest(const double *a, int n)
{
    double most = 0;
    for (int i = 0; i < n; i++) {
        most = fmax(most, fabs(a[i]));
    }
    return most;
}

static inline void element_node(const body *b, int layer, int i, double *x)
{
    const int n2 = b->plane->block[0].per_elem;
    body_node(b, i % n2, layer * b->order + i / n2, x);
}

static inline double difference(const body *a, const body *b, int layer)
{
    int n3;
    double *A = stiffness(a, layer, &n3), *B = stiffness(b, layer, &n3), worst = 0;
    for (int i = 0; i < n3 * n3; i++) {
        worst = fmax(worst, fabs(A[i] - B[i]));
    }
    worst /= largest(A, n3 * n3);
    free(A);
    free(B);
    return worst;
}

static inline void each_trial(const material *materials,
                              void (*check)(const trial *, const material *))
{
    for (int order = 1; order <= ELEMENT_MAX_ORDER; order++) {
        for (int k = 0; k < 3 * 2 * 2 * MATERIALS; k++) {
            const trial t = {.kind = k % 2 ? SHAPE_TRIANGLE : SHAPE_QUAD,
                             .mixed = k / 2 % 2,
                             .order = order,
                             .along = k / 4 % 2 ? order : 1 + order % ELEMENT_MAX_ORDER,
                             .material = k / 4 % MATERIALS,
                             .frame = k / 4 / MATERIALS - 1,
                             .bent = k / 2 % 3 > 0};
            check(&t, materials);
        }
    }
}
