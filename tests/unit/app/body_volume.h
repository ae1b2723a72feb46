// tests/unit/app/body_volume.h
// Integrals over a body that know nothing of its elements' kernels.
#pragma once

#include "fem/body.h"
#include "tests/test.h"

#include <math.h>

enum { VOLUME_MATERIALS = 8, PLANE_NODES = (ELEMENT_MAX_ORDER + 1) * (ELEMENT_MAX_ORDER + 1) };

typedef struct body_volume {
    double of[VOLUME_MATERIALS]; // [m^3] per material
    double smallest;             // det J over the mean of its element
} body_volume;

typedef struct volume_sum {
    double volume, low;
} volume_sum;

typedef struct line_point {
    double L[ELEMENT_MAX_ORDER + 1], dL[ELEMENT_MAX_ORDER + 1];
} line_point;

// where the element's nodes in its plane are at one place along it, and how they go on there
typedef struct plane_nodes {
    double at[PLANE_NODES][3], on[PLANE_NODES][3];
} plane_nodes;

static inline void plane_nodes_at(const body *b, const int *conn, int n, int layer,
                                  const line_point *line, plane_nodes *out)
{
    *out = (plane_nodes){0};
    for (int k = 0; k <= b->order; k++) {
        for (int i = 0; i < n; i++) {
            double x[3];
            body_node(b, conn[i], layer * b->order + k, x);
            for (int r = 0; r < 3; r++) {
                out->at[i][r] += line->L[k] * x[r];
                out->on[i][r] += line->dL[k] * x[r];
            }
        }
    }
}

static inline void volume_point(const plane_nodes *x, int n, const double *N, const double *dN,
                                double weight, volume_sum *sum)
{
    double J[3][3] = {{0}};
    for (int i = 0; i < n; i++) {
        for (int r = 0; r < 3; r++) {
            J[0][r] += dN[2 * i] * x->at[i][r];
            J[1][r] += dN[2 * i + 1] * x->at[i][r];
            J[2][r] += N[i] * x->on[i][r];
        }
    }
    const vec3 u = {{J[0][0], J[0][1], J[0][2]}}, v = {{J[1][0], J[1][1], J[1][2]}},
               w = {{J[2][0], J[2][1], J[2][2]}};
    const double det = vec3_dot(vec3_cross(u, v), w);
    sum->volume += weight * det;
    sum->low = fmin(sum->low, det);
}

static inline body_volume body_volumes(const body *b)
{
    body_volume out = {.smallest = INFINITY};
    double t[8], g[8];
    if (!b->plane) { // it failed, and said so
        return out;
    }
    const int ng = b->order + 2;
    line_point line[8];
    gauss_legendre(ng, t, g);
    for (int i = 0; i < ng; i++) {
        element_basis(&b->line, &t[i], line[i].L, line[i].dL);
    }
    for (int k = 0; k < b->plane->nblock; k++) {
        const mesh_block *block = &b->plane->block[k];
        const basis_table *table = &b->plane_table[k];
        for (int e = 0; e < block->nelem * b->nlayer; e++) {
            const int element = e % block->nelem, layer = e / block->nelem;
            const int material = body_material(b, k, element, layer);
            const int *conn = block->conn + (size_t)element * (size_t)block->per_elem;
            volume_sum sum = {.low = INFINITY};
            double measure = 0;
            CHECK(table->nnode <= PLANE_NODES);
            for (int q = 0; q < ng && material >= 0; q++) {
                plane_nodes x;
                plane_nodes_at(b, conn, table->nnode, layer, &line[q], &x);
                for (int p = 0; p < table->npoint; p++) {
                    measure += table->weight[p] * g[q];
                    volume_point(&x, table->nnode, table->N + p * table->nnode,
                                 table->dN + 2 * p * table->nnode, table->weight[p] * g[q], &sum);
                }
            }
            if (material >= 0) {
                CHECK(material < VOLUME_MATERIALS);
                out.of[material] += sum.volume;
                out.smallest = fmin(out.smallest, sum.low / (sum.volume / measure));
            }
        }
    }
    return out;
}
