// fem/plane_matrices.c
// Integrals over one plane element, and the Kronecker product with those along z.
#include "fem/column.h"

#include <string.h>

enum { NODES = ELEMENT_MAX_PLANE_NODES };

// int dN_a/dx_i N_b and int dN_a/dx_i dN_b/dx_j
typedef struct plane_integrals {
    double first[2][NODES][NODES];
    double second[2][2][NODES][NODES];
} plane_integrals;

// gradients in the plane and the area weight at quadrature point q; the determinant is negative in
// an inverted element
static double plane_gradient(const mesh *m, const int *conn, const basis_table *table, int q,
                             double (*grad)[2])
{
    const int n = table->nnode;
    const double *dN = table->dN + 2 * (size_t)q * (size_t)n;
    double J[2][2] = {{0}};
    for (int a = 0; a < n; a++) {
        const double *x = m->xyz + 3 * (size_t)conn[a];
        for (int i = 0; i < 2; i++) {
            J[i][0] += x[i] * dN[2 * a];
            J[i][1] += x[i] * dN[2 * a + 1];
        }
    }
    const double det = J[0][0] * J[1][1] - J[0][1] * J[1][0];
    for (int a = 0; a < n; a++) {
        const double u = dN[2 * a], v = dN[2 * a + 1];
        grad[a][0] = (J[1][1] * u - J[1][0] * v) / det;
        grad[a][1] = (J[0][0] * v - J[0][1] * u) / det;
    }
    return det * table->weight[q];
}

static void add_point(int n, double weight, const double *N, const double (*grad)[2],
                      plane_integrals *s, double *mass)
{
    for (int a = 0; a < n; a++) {
        const double gx = weight * grad[a][0], gy = weight * grad[a][1], na = weight * N[a];
        for (int b = 0; b < n; b++) {
            mass[a * n + b] += na * N[b];
            s->first[0][a][b] += gx * N[b];
            s->first[1][a][b] += gy * N[b];
            s->second[0][0][a][b] += gx * grad[b][0];
            s->second[0][1][a][b] += gx * grad[b][1];
            s->second[1][0][a][b] += gy * grad[b][0];
            s->second[1][1][a][b] += gy * grad[b][1];
        }
    }
}

// B: in-plane strains of (u_x, u_y) and the shears of u_z; S N: the shears of (u_x, u_y) and the
// stretch of u_z
static void fill_pair(const plane_integrals *s, int a, int b, plane_matrices *p)
{
    const int n3 = 3 * p->nnode;
    const double lambda = p->lambda, mu = p->mu;
    const double laplace = mu * (s->second[0][0][a][b] + s->second[1][1][a][b]);
    double *E = p->E + 3 * a * n3 + 3 * b, *C = p->C + 3 * a * n3 + 3 * b;
    for (int i = 0; i < 2; i++) {
        for (int j = 0; j < 2; j++) {
            E[i * n3 + j] = lambda * s->second[i][j][a][b] + mu * s->second[j][i][a][b] +
                            (i == j ? laplace : 0);
        }
        C[i * n3 + 2] = lambda * s->first[i][a][b];
        C[2 * n3 + i] = mu * s->first[i][a][b];
    }
    E[2 * n3 + 2] = laplace;
}

status plane_matrices_make(const column *c, int block, int element, plane_matrices *p)
{
    const mesh_block *k = &c->plane->block[block];
    const basis_table *table = &c->table[block];
    const int *conn = k->conn + (size_t)element * (size_t)k->per_elem, n = k->per_elem;
    const material *m = &c->materials[k->material[element]];
    plane_integrals s = {0};

    memset(p, 0, sizeof *p);
    p->nnode = n;
    p->mu = material_shear_modulus(m);
    p->lambda = m->E * m->nu / ((1 + m->nu) * (1 - 2 * m->nu));
    for (int q = 0; q < table->npoint; q++) {
        double grad[NODES][2];
        const double weight = plane_gradient(c->plane, conn, table, q, grad);
        if (!(weight > 0)) {
            return status_fail(ERR_NUMERIC, "segment: plane element %d is inverted", element);
        }
        add_point(n, weight, table->N + (size_t)q * (size_t)n, (const double(*)[2])grad, &s,
                  p->mass);
    }
    for (int a = 0; a < n; a++) {
        for (int b = 0; b < n; b++) {
            fill_pair(&s, a, b, p);
        }
    }
    return OK;
}

void element_stiffness(const plane_matrices *p, const line_matrices *line, int order, double *K)
{
    const int n = p->nnode, n3 = 3 * n, stride = n3 * (order + 1);
    const double stiff[3] = {p->mu, p->mu, p->lambda + 2 * p->mu};
    for (int k = 0; k <= order; k++) {
        for (int r = 0; r < n3; r++) {
            double *row = K + (size_t)(k * n3 + r) * (size_t)stride;
            const double *E = p->E + r * n3, *C = p->C + r * n3, *mass = p->mass + r / 3 * n;
            for (int l = 0; l <= order; l++, row += n3) {
                const double M1 = line->M[k][l], G = line->G[k][l], GT = line->G[l][k];
                const double K1 = line->K[k][l] * stiff[r % 3];
                for (int s = 0; s < n3; s++) {
                    row[s] = M1 * E[s] + G * C[s] + GT * p->C[s * n3 + r];
                }
                for (int b = 0; b < n; b++) {
                    row[3 * b + r % 3] += K1 * mass[b];
                }
            }
        }
    }
}
