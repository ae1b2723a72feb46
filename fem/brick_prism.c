// fem/brick_prism.c
// Elements of a prism that is the same along s: their matrices are tensor products.
#include "fem/blas.h"
#include "fem/brick_parts.h"

#include <string.h>

// (dN/dx, dN/dy, N) [3][n2] at point q; returns det J
static double plane_slopes(const brick *w, int q, double *g)
{
    const basis_table *t = &w->body->plane_table[w->block];
    const int n = w->n2;
    const double *dN = t->dN + 2 * q * n, *xyz = w->body->plane->xyz;
    double J[2][2] = {{0}};
    for (int a = 0; a < n; a++) {
        const double *x = xyz + 3 * (size_t)w->conn[a];
        for (int i = 0; i < 2; i++) {
            J[i][0] += x[i] * dN[2 * a];
            J[i][1] += x[i] * dN[2 * a + 1];
        }
    }
    const double det = J[0][0] * J[1][1] - J[0][1] * J[1][0];
    for (int a = 0; a < n; a++) {
        const double u = dN[2 * a], v = dN[2 * a + 1];
        g[a] = (J[1][1] * u - J[1][0] * v) / det;
        g[n + a] = (J[0][0] * v - J[0][1] * u) / det;
    }
    memcpy(g + 2 * n, t->N + q * n, (size_t)n * sizeof *g);
    return det;
}

// which derivatives stand to the left and to the right of Q: in the plane, or along z
typedef struct plane_part {
    int left_from, left_to, right_from, right_to;
    double *out;
} plane_part;

// H[(i, k)][b] = weight sum_l C_ijkl g[l][b], row (q, j)
static void times_law(int n, const plane_part *p, const mat6 *Q, double weight, const double *g,
                      int j, double *H)
{
    memset(H, 0, BRICK_PAIRS * (size_t)n * sizeof *H);
    if (j < p->left_from || j >= p->left_to) {
        return;
    }
    for (int ik = 0; ik < BRICK_PAIRS; ik++) {
        const int i = ik / 3, k = ik % 3;
        for (int l = p->right_from; l < p->right_to; l++) {
            const double c = weight * Q->a[brick_strain[i][j]][brick_strain[k][l]];
            for (int b = 0; c != 0 && b < n; b++) {
                H[ik * n + b] += c * g[l * n + b];
            }
        }
    }
}

static void integrate(brick *w, const plane_part *p)
{
    const int n = w->n2, wide = BRICK_PAIRS * n;
    for (int q = 0; q < w->np; q++) {
        for (int j = 0; j < 3; j++) {
            times_law(n, p, &w->stiffness[q], w->dV[q], w->work + 3 * q * n, j,
                      w->more + (size_t)(3 * q + j) * (size_t)wide);
        }
    }
    blas_product(n, wide, 3 * w->np, w->work, w->more, 0, w->sum);
    for (int a = 0; a < n; a++) {
        for (int ik = 0; ik < BRICK_PAIRS; ik++) {
            const double *from = w->sum + a * wide + ik * n;
            double *to = p->out + (3 * a + ik / 3) * 3 * n + ik % 3;
            for (int b = 0; b < n; b++) {
                to[3 * b] = from[b];
            }
        }
    }
}

static void plane_place(const brick *w, int q, double x[2])
{
    const double *N = w->body->plane_table[w->block].N + q * w->n2;
    x[0] = x[1] = 0;
    for (int a = 0; a < w->n2; a++) {
        const double *from = w->body->plane->xyz + 3 * (size_t)w->conn[a];
        x[0] += N[a] * from[0];
        x[1] += N[a] * from[1];
    }
}

static status make_flat(brick *w, int material, brick_plane *flat)
{
    status st = OK;
    brick_law law;
    TRY(brick_law_at(w->body, w->block, w->e, material, 0, &law));
    w->layer = -1; // dV is borrowed
    for (int q = 0; q < w->np; q++) {
        const double det = plane_slopes(w, q, w->work + 3 * q * w->n2);
        double grade, x[2];
        plane_place(w, q, x);
        if (!(det > 0)) {
            TRY(status_fail(ERR_NUMERIC,
                            "segment: plane element %d at x = %.6g mm, y = %.6g mm is inverted",
                            w->e, 1e3 * x[0], 1e3 * x[1]));
        }
        TRY(brick_grade(&law, x[0], x[1], 0, &grade));
        w->dV[q] = grade * det * w->body->plane_table[w->block].weight[q];
        w->stiffness[q] = q == 0 || brick_law_is_polar(&law)
                              ? brick_section_stiffness(&law, x[0], x[1])
                              : w->stiffness[0];
    }
    const plane_part parts[] = {
        {0, 2, 0, 2, flat->E},
        {0, 2, 2, 3, flat->C},
        {2, 3, 0, 2, flat->Ct},
        {2, 3, 2, 3, flat->M},
    };
    for (size_t i = 0; i < sizeof parts / sizeof *parts; i++) {
        integrate(w, &parts[i]);
    }
    flat->material = material;

done:
    return st;
}

// the plane matrices of a material: stacks change between a few of them from layer to layer
static status find_flat(brick *w, int material, const brick_plane **out)
{
    status st = OK;
    brick_plane *flat = NULL;
    for (int i = 0; i < BRICK_PLANES && !flat; i++) {
        flat = w->flat[i].material == material ? &w->flat[i] : NULL;
    }
    if (!flat) {
        flat = &w->flat[w->oldest];
        w->oldest = (w->oldest + 1) % BRICK_PLANES;
        flat->material = -1;
        TRY(make_flat(w, material, flat));
    }
    *out = flat;

done:
    return st;
}

enum { LINE_NODES = ELEMENT_MAX_ORDER + 1 };

// int N N^T, int N N'^T, int N' N'^T along a layer
typedef struct layer_matrices {
    double M[LINE_NODES][LINE_NODES], G[LINE_NODES][LINE_NODES], K[LINE_NODES][LINE_NODES];
} layer_matrices;

static layer_matrices along_layer(const body *b, int layer)
{
    layer_matrices m = {0};
    const basis_table *t = &b->line_table;
    const double half = (b->level[(layer + 1) * b->order] - b->level[layer * b->order]) / 2;
    for (int q = 0; q < t->npoint; q++) {
        const double *N = t->N + q * t->nnode, *dN = t->dN + q * t->nnode, weight = t->weight[q];
        for (int k = 0; k < t->nnode; k++) {
            for (int l = 0; l < t->nnode; l++) {
                m.M[k][l] += weight * half * N[k] * N[l];
                m.G[k][l] += weight * N[k] * dN[l];
                m.K[k][l] += weight / half * dN[k] * dN[l];
            }
        }
    }
    return m;
}

// (5.1)
status brick_prism_stiffness(brick *w, int layer, int material, double *K)
{
    status st = OK;
    const int n3 = 3 * w->n2, nline = w->body->order + 1;
    const brick_plane *flat = NULL;
    TRY(find_flat(w, material, &flat));
    const layer_matrices m = along_layer(w->body, layer);
    for (int k = 0; k < nline; k++) {
        for (int r = 0; r < n3; r++) {
            const double *E = flat->E + r * n3, *C = flat->C + r * n3;
            const double *Ct = flat->Ct + r * n3, *M = flat->M + r * n3;
            for (int l = 0; l < nline; l++) {
                const double e = m.M[k][l], c = m.G[k][l], ct = m.G[l][k], z = m.K[k][l];
                double *to = K + (size_t)(k * n3 + r) * (size_t)(n3 * nline) + l * n3;
                for (int s = 0; s < n3; s++) {
                    to[s] = e * E[s] + c * C[s] + ct * Ct[s] + z * M[s];
                }
            }
        }
    }

done:
    return st;
}
