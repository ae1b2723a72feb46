// section/strains.h
// Strains at one point of a section from its fields, and the nodes' shares of stresses, for several
// columns at once: arrays are [6][n] by rows.
#pragma once

#include "section/matter.h"

// S Z of docs/theory.md (2.1) and (3.1): strains of unit generalized strains, [6][6]
static inline mat6 rigid_strains(double x, double y)
{
    mat6 SZ = {0};
    SZ.a[XZ][0] = SZ.a[YZ][1] = SZ.a[ZZ][2] = 1;
    SZ.a[ZZ][3] = y;
    SZ.a[ZZ][4] = -x;
    SZ.a[XZ][5] = -y;
    SZ.a[YZ][5] = x;
    return SZ;
}

// S Z psi
static inline void set_rigid_strains(int n, double x, double y, const double *psi, double *strain)
{
    for (int k = 0; k < n; k++) {
        strain[XX * n + k] = strain[YY * n + k] = strain[XY * n + k] = 0;
        strain[ZZ * n + k] = psi[2 * n + k] + y * psi[3 * n + k] - x * psi[4 * n + k];
        strain[YZ * n + k] = psi[n + k] + x * psi[5 * n + k];
        strain[XZ * n + k] = psi[k] - y * psi[5 * n + k];
    }
}

// (B + k S D) w, from values and derivatives [3][n] along x and y
static inline void add_warping_strains(int n, double rate, double x, double y, const double *w,
                                       const double *wx, const double *wy, double *strain)
{
    for (int k = 0; k < n; k++) {
        const double turn[3] = {
            rate * (y * wx[k] - x * wy[k] - w[n + k]),
            rate * (y * wx[n + k] - x * wy[n + k] + w[k]),
            rate * (y * wx[2 * n + k] - x * wy[2 * n + k]),
        };
        strain[XX * n + k] += wx[k];
        strain[YY * n + k] += wy[n + k];
        strain[ZZ * n + k] += turn[2];
        strain[YZ * n + k] += wy[2 * n + k] + turn[1];
        strain[XZ * n + k] += wx[2 * n + k] + turn[0];
        strain[XY * n + k] += wy[k] + wx[n + k];
    }
}

// c S N w', from the values [3][n]
static inline void add_slope_strains(int n, double c, const double *dw, double *strain)
{
    for (int k = 0; k < n; k++) {
        strain[XZ * n + k] += c * dw[k];
        strain[YZ * n + k] += c * dw[n + k];
        strain[ZZ * n + k] += c * dw[2 * n + k];
    }
}

static inline void multiply_stiffness(const mat6 *Q, int n, const double *strain, double *stress)
{
    for (int i = 0; i < 6; i++) {
        for (int k = 0; k < n; k++) {
            double sum = 0;
            for (int j = 0; j < 6; j++) {
                sum += Q->a[i][j] * strain[j * n + k];
            }
            stress[i * n + k] = sum;
        }
    }
}

// (S Z)^T stress, [6][n]
static inline void add_resultants(int n, double x, double y, double weight, const double *stress,
                                  double *wrench)
{
    for (int k = 0; k < n; k++) {
        const double xz = weight * stress[XZ * n + k], yz = weight * stress[YZ * n + k];
        const double zz = weight * stress[ZZ * n + k];
        wrench[k] += xz;
        wrench[n + k] += yz;
        wrench[2 * n + k] += zz;
        wrench[3 * n + k] += y * zz;
        wrench[4 * n + k] -= x * zz;
        wrench[5 * n + k] += x * yz - y * xz;
    }
}

// One node's values at a point: N, the derivatives, and k times the one that turns.
typedef struct node_values {
    double N, Nx, Ny, turning;
} node_values;

static inline node_values node_at(const plane_element *e, int q, int i, double rate)
{
    const double Nx = e->Nx[q * e->nnode + i], Ny = e->Ny[q * e->nnode + i];
    return (node_values){e->N[q * e->nnode + i], Nx, Ny, rate * (e->y[q] * Nx - e->x[q] * Ny)};
}

// c (B_i + k S D_i)^T stress, of column k
static inline void add_node_force(const node_values *v, double rate, double c, int n, int k,
                                  const double *stress, double *to)
{
    const double xx = c * stress[XX * n + k], yy = c * stress[YY * n + k];
    const double zz = c * stress[ZZ * n + k], yz = c * stress[YZ * n + k];
    const double xz = c * stress[XZ * n + k], xy = c * stress[XY * n + k];
    to[0] += v->Nx * xx + v->Ny * xy + v->turning * xz + rate * v->N * yz;
    to[1] += v->Ny * yy + v->Nx * xy + v->turning * yz - rate * v->N * xz;
    to[2] += v->Nx * xz + v->Ny * yz + v->turning * zz;
}

// c (S N_i)^T stress, of column k
static inline void add_slope_force(double N, double c, int n, int k, const double *stress,
                                   double *to)
{
    to[0] += c * N * stress[XZ * n + k];
    to[1] += c * N * stress[YZ * n + k];
    to[2] += c * N * stress[ZZ * n + k];
}
