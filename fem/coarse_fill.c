// fem/coarse_fill.c
// The matrix of the coarse space: P^T K P.
#include "fem/coarse_parts.h"

#include "base/memory.h"
#include "fem/blas.h"

#include <string.h>

static double *entry(coarse *c, int row, int column)
{
    const int up = row < column ? row : column, right = row < column ? column : row;
    return c->matrix + (size_t)right * (size_t)(c->band + 1) + (size_t)(c->band + up - right);
}

// one block of two levels: X [count][count], rows of the lower level
static void add_block(coarse *c, int level, int other, double factor, const double *X)
{
    for (int i = 0; i < c->count; i++) {
        for (int j = level == other ? i : 0; j < c->count; j++) {
            *entry(c, level * c->count + i, other * c->count + j) += factor * X[i * c->count + j];
        }
    }
}

// --- of a prism: plane forms and forms along s

typedef struct line_forms {
    double M, G, GT, K;
} line_forms;

static line_forms forms_of(const body *b, int layer, int i, int j)
{
    line_forms f = {0};
    const int p = b->order;
    const basis_table *t = &b->line_table;
    const double half = (b->level[(layer + 1) * p] - b->level[layer * p]) / 2;
    for (int q = 0; q < t->npoint; q++) {
        const double *N = t->N + q * (p + 1), *dN = t->dN + q * (p + 1), w = t->weight[q];
        f.M += half * w * N[i] * N[j];
        f.G += w * N[i] * dN[j];
        f.GT += w * dN[i] * N[j];
        f.K += w / half * dN[i] * dN[j];
    }
    return f;
}

// W^T A W, W [3n][count] all modes
static status project(coarse *c, plane_form which, const double *W, double *X)
{
    status st = OK;
    const int n3 = 3 * c->spec.body->plane->nnode;
    double *AW = NULL;
    TRY(TAKE(AW, (size_t)n3 * (size_t)c->count));
    TRY(plane_forms_multiply(c->spec.forms, which, false, c->count, W, AW));
    blas_product(c->count, c->count, n3, W, AW, 0, X);

done:
    free(AW);
    return st;
}

static void all_modes(coarse *c, double *W)
{
    const size_t n3 = 3 * (size_t)c->spec.body->plane->nnode, more = (size_t)c->spec.modes->count;
    section_rigid(c->spec.body, 0, c->rigid);
    for (size_t i = 0; i < n3; i++) {
        double *to = W + i * (size_t)c->count;
        memcpy(to, c->rigid + i * COARSE_RIGID, COARSE_RIGID * sizeof *to);
        memcpy(to + COARSE_RIGID, c->spec.modes->value + i * more, more * sizeof *to);
    }
}

// all levels have all modes; those not active are taken out afterwards
static status fill_prism(coarse *c)
{
    status st = OK;
    const body *b = c->spec.body;
    const size_t n = (size_t)c->count, all = n * n;
    double *X = NULL, *W = NULL;
    TRY(TAKE(X, 4 * all));
    TRY(TAKE(W, 3 * (size_t)b->plane->nnode * n));
    double *E = X, *C = X + all, *M = X + 2 * all, *Ct = X + 3 * all;
    all_modes(c, W);
    TRY(project(c, FORM_E, W, E));
    TRY(project(c, FORM_C, W, C));
    TRY(project(c, FORM_M, W, M));
    for (size_t i = 0; i < all; i++) {
        Ct[i] = C[i % n * n + i / n];
    }
    for (int layer = 0; layer < b->nlayer; layer++) {
        for (int i = 0; i <= b->order; i++) {
            for (int j = i; j <= b->order; j++) {
                const line_forms f = forms_of(b, layer, i, j);
                const int low = layer * b->order + i, high = layer * b->order + j;
                add_block(c, low, high, f.M, E);
                add_block(c, low, high, f.G, C);
                add_block(c, low, high, f.GT, Ct);
                add_block(c, low, high, f.K, M);
            }
        }
    }

done:
    free(X);
    free(W);
    return st;
}

// --- of any body: products with the modes of one level at a time

static status fill_layer(coarse *c, int layer, const double *one, double *u, double *f, double *X)
{
    status st = OK;
    const body *b = c->spec.body;
    const int p = b->order;
    const size_t block = 3 * (size_t)b->plane->nnode * (size_t)c->count;
    for (int j = 0; j <= p; j++) {
        memset(u, 0, (size_t)(p + 1) * block * sizeof *u);
        memset(f, 0, (size_t)(p + 1) * block * sizeof *f);
        coarse_prolong(c, layer * p + j, c->count, one, u + (size_t)j * block);
        TRY(apply_layers(c->spec.product, layer, layer + 1, c->count, u, f));
        for (int i = 0; i <= j; i++) {
            coarse_restrict(c, layer * p + i, c->count, f + (size_t)i * block, X);
            add_block(c, layer * p + i, layer * p + j, 1, X);
        }
    }

done:
    return st;
}

static status fill_any(coarse *c)
{
    status st = OK;
    const body *b = c->spec.body;
    const size_t count = (size_t)c->count, block = 3 * (size_t)b->plane->nnode * count;
    double *u = NULL, *f = NULL, *X = NULL, *one = NULL;
    TRY(TAKE(u, ((size_t)b->order + 1) * block));
    TRY(TAKE(f, ((size_t)b->order + 1) * block));
    TRY(TAKE(X, count * count));
    TRY(TAKE(one, count * count));
    for (size_t i = 0; i < count; i++) {
        one[i * count + i] = 1;
    }
    for (int layer = c->spec.first_layer; layer < c->spec.last_layer; layer++) {
        TRY(fill_layer(c, layer, one, u, f, X));
    }

done:
    free(u);
    free(f);
    free(X);
    free(one);
    return st;
}

// --- whole

static void take_out(coarse *c)
{
    const int nlevel = c->spec.body->nlevel;
    for (int level = 0; level < nlevel; level += nlevel - 1) {
        for (int k = 0; k < c->count; k++) {
            const int at = level * c->count + k;
            if (coarse_is_active(c, level, k)) {
                continue;
            }
            for (int other = 0; other < c->size; other++) {
                if (other - at <= c->band && at - other <= c->band) {
                    *entry(c, at, other) = 0;
                }
            }
            *entry(c, at, at) = 1;
        }
    }
}

// the answer does not depend on what holds motions that cost nothing, since loads balance
static void hold_drift(coarse *c)
{
    static const int free_motion[3] = {0, 1, 5};
    for (int k = 0; c->spec.drifts && k < 3; k++) {
        *entry(c, free_motion[k], free_motion[k]) *= 2;
    }
}

static void sum_over_ranks(coarse *c)
{
    // by parts: MPI counts with int
    for (int level = 0; level < c->spec.body->nlevel; level++) {
        const size_t part = (size_t)c->count * (size_t)(c->band + 1);
        c->spec.door->sum((int)part, c->matrix + (size_t)level * part);
    }
}

status coarse_fill(coarse *c)
{
    status st = OK;
    const body *b = c->spec.body;
    bool same = b->prism;
    for (int k = 0; k < b->plane->nblock; k++) {
        for (int e = 0; e < b->plane->block[k].nelem; e++) {
            same &= !material_varies(&b->spec.materials[b->plane->block[k].material[e]]);
        }
    }
    if (same) {
        TRY(fill_prism(c));
    } else {
        const status mine = fill_any(c);
        TRY(c->spec.door->agree(mine));
        sum_over_ranks(c);
    }
    take_out(c);
    hold_drift(c);

done:
    return st;
}
