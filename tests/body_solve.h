// tests/body_solve.h
// A body's equations for tests, solved by a banded Cholesky: nodes level after level, any direction
// of any node held at any value.
#pragma once

#include "base/memory.h"
#include "fem/brick_parts.h"
#include "fem/face.h"
#include "tests/test.h"

#include <string.h>

void dpbtrf_(const char *triangle, const int *n, const int *half, double *a, const int *lda,
             int *info);
void dpbtrs_(const char *triangle, const int *n, const int *half, const int *nrhs, const double *a,
             const int *lda, double *b, const int *ldb, int *info);

typedef struct equations {
    const body *body;
    int n, half;   // unknowns, and entries beside the diagonal
    double *A;     // [n][half + 1] lower triangle column by column
    double *f;     // [n] forces, then displacements
    bool *held;    // [n]
    double *value; // [n] of held ones
} equations;

static inline void equations_free(equations *s)
{
    free(s->A);
    free(s->f);
    free(s->held);
    free(s->value);
    *s = (equations){0};
}

static inline void equations_make(const body *b, equations *s)
{
    *s = (equations){.body = b, .n = 3 * (int)body_node_count(b)};
    s->half = 3 * b->plane->nnode * (b->order + 1) - 1;
    CHECK_OK(TAKE(s->A, (size_t)s->n * (size_t)(s->half + 1)));
    CHECK_OK(TAKE(s->f, (size_t)s->n));
    CHECK_OK(TAKE(s->held, (size_t)s->n));
    CHECK_OK(TAKE(s->value, (size_t)s->n));
}

static inline int equation_of(const body *b, int plane_node, int level, int direction)
{
    return 3 * (level * b->plane->nnode + plane_node) + direction;
}

static inline void hold(equations *s, int plane_node, int level, int direction, double value)
{
    const int i = equation_of(s->body, plane_node, level, direction);
    s->held[i] = true;
    s->value[i] = value;
}

static inline double *entry(const equations *s, int row, int column)
{
    const int low = row > column ? column : row, gap = row > column ? row - column : column - row;
    return s->A + (size_t)low * (size_t)(s->half + 1) + gap;
}

// numbers of the unknowns of an element of a layer
static inline void element_unknowns(const brick *w, int layer, int *number)
{
    for (int i = 0; i < 3 * w->n; i++) {
        number[i] = equation_of(w->body, w->conn[i / 3 % w->n2],
                                layer * w->body->order + i / 3 / w->n2, i % 3);
    }
}

// visits all elements with matter; they stand
typedef void (*element_visit)(brick *w, int layer, void *self);
static inline void each_element(const body *b, element_visit visit, void *self)
{
    brick *w = NULL;
    CHECK_OK(brick_make(b, &w));
    for (int k = 0; k < b->plane->nblock; k++) {
        for (int e = 0; e < b->plane->block[k].nelem; e++) {
            CHECK_OK(brick_stand_on(w, k, e));
            for (int layer = 0; layer < b->nlayer; layer++) {
                if (body_material(b, k, e, layer) >= 0) {
                    visit(w, layer, self);
                }
            }
        }
    }
    brick_free(w);
}

static inline void add_stiffness(brick *w, int layer, void *self)
{
    const equations *s = (const equations *)self;
    static double K[BRICK_MAX_DOFS * BRICK_MAX_DOFS];
    int number[BRICK_MAX_DOFS];
    const int n3 = 3 * w->n;
    CHECK_OK(brick_stiffness(w, layer, K));
    element_unknowns(w, layer, number);
    for (int r = 0; r < n3; r++) {
        for (int c = 0; c < n3; c++) {
            if (number[r] >= number[c]) {
                *entry(s, number[r], number[c]) += K[r * n3 + c];
            }
        }
    }
}

static inline void assemble(equations *s)
{
    each_element(s->body, add_stiffness, s);
}

// Held rows and columns go; the answer is in s->f.
static inline void solve(equations *s)
{
    const int lda = s->half + 1, one = 1;
    int info = 0;
    for (int j = 0; j < s->n; j++) {
        for (int i = j; i <= j + s->half && i < s->n; i++) {
            double *a = entry(s, i, j);
            if (s->held[i] && !s->held[j]) {
                s->f[j] -= *a * s->value[i];
            } else if (s->held[j] && !s->held[i]) {
                s->f[i] -= *a * s->value[j];
            }
            if (s->held[i] || s->held[j]) {
                *a = i == j;
            }
        }
    }
    for (int i = 0; i < s->n; i++) {
        s->f[i] = s->held[i] ? s->value[i] : s->f[i];
    }
    dpbtrf_("L", &s->n, &s->half, s->A, &lda, &info);
    CHECK(info == 0);
    dpbtrs_("L", &s->n, &s->half, &one, s->A, &lda, s->f, &s->n, &info);
}

static inline void element_displacements(const equations *s, const brick *w, int layer, double *u)
{
    int number[BRICK_MAX_DOFS];
    element_unknowns(w, layer, number);
    for (int i = 0; i < 3 * w->n; i++) {
        u[i] = s->f[number[i]];
    }
}

// bases at quadrature point q of the element at hand
static inline double basis_at(const brick *w, int q, int node)
{
    const basis_table *plane = &w->body->plane_table[w->block], *line = &w->body->line_table;
    return plane->N[q % w->np * w->n2 + node % w->n2] *
           line->N[q / w->np * line->nnode + node / w->n2];
}

// holds a direction of all nodes at which a function is true
static inline void hold_where(equations *s, bool (*where)(const double *x), int direction)
{
    const body *b = s->body;
    for (int level = 0; level < b->nlevel; level++) {
        for (int i = 0; i < b->plane->nnode; i++) {
            double x[3];
            body_node(b, i, level, x);
            if (where(x)) {
                hold(s, i, level, direction, 0);
            }
        }
    }
}
