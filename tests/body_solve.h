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

// displacement of the node nearest to a place
static inline void displacement_at(const equations *s, const double *place, double *u)
{
    const body *b = s->body;
    double best = INFINITY;
    for (int level = 0; level < b->nlevel; level++) {
        for (int i = 0; i < b->plane->nnode; i++) {
            double x[3];
            body_node(b, i, level, x);
            const double d = hypot(hypot(x[0] - place[0], x[1] - place[1]), x[2] - place[2]);
            if (d < best) {
                best = d;
                memcpy(u, s->f + equation_of(b, i, level, 0), 3 * sizeof *u);
            }
        }
    }
}

// stress at a node that is nearest to a place, the mean over the elements that have it
typedef struct stress_probe {
    const equations *s;
    const double *place;
    double nearest, stress[6];
    int count;
} stress_probe;

static inline void probe_element(brick *w, int layer, void *self)
{
    stress_probe *p = (stress_probe *)self;
    const element *line = &w->body->line;
    double u[BRICK_MAX_DOFS], strain[6], stress[6];
    element_displacements(p->s, w, layer, u);
    for (int i = 0; i < w->n; i++) {
        double x[3];
        body_node(w->body, w->conn[i % w->n2], layer * w->body->order + i / w->n2, x);
        const double d = hypot(hypot(x[0] - p->place[0], x[1] - p->place[1]), x[2] - p->place[2]);
        if (d > p->nearest * (1 + 1e-9) + 1e-12) {
            continue;
        }
        if (d < p->nearest * (1 - 1e-9) - 1e-12) {
            p->nearest = d;
            p->count = 0;
            memset(p->stress, 0, sizeof p->stress);
        }
        const double at[3] = {w->plane.node[i % w->n2][0], w->plane.node[i % w->n2][1],
                              line->node[i / w->n2][0]};
        CHECK_OK(brick_stress_at(w, layer, at, u, strain, stress, NULL));
        p->count++;
        for (int c = 0; c < 6; c++) {
            p->stress[c] += (stress[c] - p->stress[c]) / p->count;
        }
    }
}

static inline stress_probe stress_near(const equations *s, const double *place)
{
    stress_probe p = {.s = s, .place = place, .nearest = INFINITY};
    each_element(s->body, probe_element, &p);
    return p;
}

// a traction on those patches of the walls or ends whose nodes all satisfy a condition
typedef struct partial_load {
    equations *s;
    bool (*where)(const double *x);
    double pressure, traction[3], area;
} partial_load;

static inline status add_partial(void *self, const face_patch *p)
{
    partial_load *l = (partial_load *)self;
    for (int i = 0; i < p->nnode; i++) {
        double x[3];
        body_node(l->s->body, p->plane_node[i], p->level[i], x);
        if (!l->where(x)) {
            return OK;
        }
    }
    for (int q = 0; q < p->npoint; q++) {
        l->area += p->dA[q];
        for (int i = 0; i < p->nnode; i++) {
            for (int d = 0; d < 3; d++) {
                l->s->f[equation_of(l->s->body, p->plane_node[i], p->level[i], d)] +=
                    p->dA[q] * p->N[q][i] * (l->traction[d] - l->pressure * p->normal[q][d]);
            }
        }
    }
    return OK;
}

static inline void load_where(partial_load *l, int face)
{
    const face_part part = {face, -INFINITY, INFINITY};
    CHECK_OK(face_walk(l->s->body, &part, 0, l->s->body->nlayer, add_partial, l));
}
