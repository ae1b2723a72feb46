// fem/doubling_slab.c
#include "fem/doubling_slab.h"

#include "base/memory.h"
#include "fem/brick.h"

#include <math.h>
#include <string.h>

// Forces of a motion and of its image agree to this part of what the elements' forces add up from
static const double SYMMETRIC = 1e-9;

void slab_free(slab *s)
{
    for (int e = 0; s->K && e < s->nelem; e++) {
        free(s->K[e]);
    }
    free(s->K);
    *s = (slab){0};
}

// nodes of element e, counted over the blocks
static const int *element_nodes(const mesh *plane, int e, int *count)
{
    const mesh_block *k = plane->block;
    for (; e >= k->nelem; k++) {
        e -= k->nelem;
    }
    *count = k->per_elem;
    return k->conn + (size_t)e * (size_t)k->per_elem;
}

// K -> A^T K A, A turning the directions of every node at level k by angle[k]
static void turn_element(double *K, int nodes, int levels, const double *angle)
{
    const int n = 3 * nodes * levels;
    for (int pass = 0; pass < 2; pass++) {
        for (int i = 0; i < nodes * levels; i++) {
            const double c = cos(angle[i / nodes]), s = sin(angle[i / nodes]);
            for (int j = 0; j < n; j++) {
                double *x =
                    pass ? K + (size_t)j * (size_t)n + 3 * i : K + (size_t)(3 * i) * (size_t)n + j;
                double *y = x + (pass ? 1 : n);
                const double u = *x, v = *y;
                *x = c * u + s * v;
                *y = c * v - s * u;
            }
        }
    }
}

static status fill(const body *b, double turn_angle, slab *s)
{
    status st = OK;
    brick *w = NULL;
    double angle[ELEMENT_MAX_ORDER + 1];
    int number = 0;
    for (int k = 0; k <= s->order; k++) {
        angle[k] = turn_angle + b->spec.turn_rate * b->level[k];
    }
    TRY(brick_make(b, &w));
    for (int block = 0; block < b->plane->nblock; block++) {
        const mesh_block *m = &b->plane->block[block];
        const size_t dofs = 3 * (size_t)m->per_elem * (size_t)(s->order + 1);
        for (int e = 0; e < m->nelem; e++, number++) {
            TRY(TAKE(s->K[number], dofs * dofs));
            TRY(brick_stand_on(w, block, e));
            TRY(brick_stiffness(w, 0, s->K[number]));
            if (turn_angle != 0 || b->spec.turn_rate != 0) {
                turn_element(s->K[number], m->per_elem, s->order + 1, angle);
            }
        }
    }

done:
    brick_free(w);
    return st;
}

status slab_make(const body *thin, double angle, slab *out)
{
    status st = OK;
    slab s = {.plane = thin->plane,
              .order = thin->order,
              .nelem = mesh_element_count(thin->plane),
              .height = thin->length,
              .turn = thin->spec.turn_rate * thin->length};
    TRY(TAKE(s.K, (size_t)s.nelem));
    TRY(fill(thin, angle, &s));
    *out = s;
    s = (slab){0};

done:
    slab_free(&s);
    return st;
}

// --- symmetries

// f = K x and size = |K| |x|, [order + 1][nplane][3]
static void multiply(const slab *s, const double *x, double *f, double *size)
{
    const int nplane = s->plane->nnode;
    for (int e = 0; e < s->nelem; e++) {
        int count = 0;
        const int *conn = element_nodes(s->plane, e, &count);
        const int n = count * (s->order + 1);
        const double *K = s->K[e];
        for (int i = 0; i < 3 * n; i++, K += 3 * n) {
            double sum = 0, all = 0;
            for (int j = 0; j < n; j++) {
                const double *u = x + 3 * (size_t)(conn[j % count] + nplane * (j / count));
                for (int d = 0; d < 3; d++) {
                    sum += K[3 * j + d] * u[d];
                    all += fabs(K[3 * j + d] * u[d]);
                }
            }
            const size_t at =
                3 * (size_t)(conn[i / 3 % count] + nplane * (i / 3 / count)) + (size_t)(i % 3);
            f[at] += sum;
            size[at] += all;
        }
    }
}

static void apply(const slab *s, const involution *g, bool reversed, const double *x, double *y)
{
    const int nplane = s->plane->nnode, p = s->order;
    for (int k = 0; k <= p; k++) {
        for (int i = 0; i < nplane; i++) {
            const int to = (g->image ? g->image[i] : i) + nplane * (reversed ? p - k : k);
            for (int d = 0; d < 3; d++) {
                y[3 * (size_t)to + (size_t)d] =
                    g->sign[d] * x[3 * (size_t)(i + nplane * k) + (size_t)d];
            }
        }
    }
}

status slab_has(const slab *s, const involution *g, bool reversed, bool *out)
{
    status st = OK;
    const size_t n = (size_t)slab_level_dofs(s) * (size_t)(s->order + 1);
    double *x = NULL;
    unsigned state = 1;
    TRY(TAKE(x, 6 * n));
    double *y = x + n, *fx = x + 2 * n, *fy = x + 3 * n, *image = x + 4 * n, *size = x + 5 * n;
    for (size_t i = 0; i < n; i++) {
        state = state * 1664525u + 1013904223u;
        x[i] = (double)(state >> 8) / (1 << 24) - 0.5;
    }
    apply(s, g, reversed, x, y);
    multiply(s, x, fx, size);
    memset(size, 0, n * sizeof *size);
    multiply(s, y, fy, size);
    apply(s, g, reversed, fx, image);
    *out = true;
    for (size_t i = 0; i < n && *out; i++) {
        *out = fabs(image[i] - fy[i]) <= SYMMETRIC * size[i];
    }

done:
    free(x);
    return st;
}
