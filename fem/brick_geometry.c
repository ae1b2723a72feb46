// fem/brick_geometry.c
#include "fem/brick_parts.h"

#include <string.h>

// (plane basis) x (line basis), slope [3][n]
static void product(int n2, int nline, const double *N, const double *dN, const double *L,
                    const double *dL, double *slope)
{
    const int n = n2 * nline;
    for (int k = 0; k < nline; k++) {
        for (int a = 0; a < n2; a++) {
            const int i = k * n2 + a;
            slope[i] = dN[2 * a] * L[k];
            slope[n + i] = dN[2 * a + 1] * L[k];
            slope[2 * n + i] = N[a] * dL[k];
        }
    }
}

status brick_tables(brick *w)
{
    status st = OK;
    const body *b = w->body;
    const basis_table *plane = &b->plane_table[w->block], *line = &b->line_table;
    TRY(element_make(b->plane->block[w->block].shape, b->plane->order, &w->plane));
    w->n2 = plane->nnode;
    w->n = w->n2 * line->nnode;
    w->np = plane->npoint;
    w->nl = line->npoint;
    w->nq = w->np * w->nl;
    for (int k = 0; k < w->nl; k++) {
        for (int i = 0; i < w->np; i++) {
            const int q = k * w->np + i;
            w->weight[q] = plane->weight[i] * line->weight[k];
            product(w->n2, line->nnode, plane->N + i * w->n2, plane->dN + 2 * i * w->n2,
                    line->N + k * line->nnode, line->dN + k * line->nnode,
                    w->slope + 3 * (size_t)q * (size_t)w->n);
        }
    }
    if (b->spec.mixed) {
        brick_choose_pressures(w);
    }

done:
    return st;
}

double brick_arclength(const brick *w, int layer, double at)
{
    const int p = w->body->order;
    const double begin = w->body->level[layer * p], end = w->body->level[(layer + 1) * p];
    return begin + (end - begin) * (at + 1) / 2;
}

// J[j][i] = dx_i / dxi_j
static mat3 jacobian(const brick *w, const double *slope)
{
    mat3 J = {0};
    for (int j = 0; j < 3; j++) {
        const double *d = slope + j * w->n;
        double x = 0, y = 0, z = 0;
        for (int a = 0; a < w->n; a++) {
            x += d[a] * w->xyz[3 * a];
            y += d[a] * w->xyz[3 * a + 1];
            z += d[a] * w->xyz[3 * a + 2];
        }
        memcpy(J.a[j], (const double[3]){x, y, z}, sizeof J.a[j]);
    }
    return J;
}

// its inverse's columns are the cross products of its rows over the determinant
static double invert(mat3 J, mat3 *inverse)
{
    vec3 row[3], cross[3];
    for (int i = 0; i < 3; i++) {
        memcpy(row[i].a, J.a[i], sizeof J.a[i]);
    }
    for (int i = 0; i < 3; i++) {
        cross[i] = vec3_cross(row[(i + 1) % 3], row[(i + 2) % 3]);
    }
    const double det = vec3_dot(row[0], cross[0]);
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            inverse->a[i][j] = cross[j].a[i] / det;
        }
    }
    return det;
}

// dN/dx_i = sum_j (J^-1)_ij dN/dxi_j; returns det J
static double turn_slopes(const brick *w, const double *slope, double *grad)
{
    mat3 back;
    const double det = invert(jacobian(w, slope), &back);
    const int n = w->n;
    const double *u = slope, *v = slope + n, *t = slope + 2 * n;
    for (int i = 0; i < 3; i++) {
        const double a = back.a[i][0], b = back.a[i][1], c = back.a[i][2];
        double *to = grad + i * n;
        for (int k = 0; k < n; k++) {
            to[k] = a * u[k] + b * v[k] + c * t[k];
        }
    }
    return det;
}

static status inverted(const brick *w, int layer, double det)
{
    const double *x = w->xyz;
    return status_fail(ERR_NUMERIC,
                       "segment: the %s of layer %d at x = %.6g mm, y = %.6g mm, z = %.6g mm is "
                       "inverted, det J = %.3g",
                       w->plane.shape == SHAPE_QUAD ? "hex" : "prism", layer, 1e3 * x[0],
                       1e3 * x[1], 1e3 * x[2], det);
}

static void take_nodes(brick *w, int layer)
{
    const int p = w->body->order;
    for (int k = 0; k <= p; k++) {
        for (int a = 0; a < w->n2; a++) {
            body_node(w->body, w->conn[a], layer * p + k, w->xyz + 3 * (k * w->n2 + a));
        }
    }
}

// places by the basis, which the tables have for the plane and the line alone
void brick_places(brick *w)
{
    if (w->placed) {
        return;
    }
    const basis_table *plane = &w->body->plane_table[w->block], *line = &w->body->line_table;
    memset(w->place, 0, (size_t)w->nq * sizeof *w->place);
    for (int q = 0; q < w->nq; q++) {
        const double *N = plane->N + q % w->np * w->n2, *L = line->N + q / w->np * line->nnode;
        for (int i = 0; i < w->n; i++) {
            const double value = N[i % w->n2] * L[i / w->n2];
            for (int d = 0; d < 3; d++) {
                w->place[q][d] += value * w->xyz[3 * i + d];
            }
        }
    }
    w->placed = true;
}

status brick_geometry(brick *w, int layer)
{
    if (w->layer == layer) {
        return OK;
    }
    w->layer = -1;
    w->projected = w->placed = false;
    take_nodes(w, layer);
    for (int q = 0; q < w->nq; q++) {
        const size_t at = 3 * (size_t)q * (size_t)w->n;
        const double det = turn_slopes(w, w->slope + at, w->grad + at);
        if (!(det > 0)) {
            return inverted(w, layer, det);
        }
        w->dV[q] = det * w->weight[q];
    }
    w->layer = layer;
    return OK;
}

double brick_point(const brick *w, const double at[3], double *N, double *grad)
{
    double N2[ELEMENT_MAX_PLANE_NODES], dN2[2 * ELEMENT_MAX_PLANE_NODES];
    double L[ELEMENT_MAX_ORDER + 1], dL[ELEMENT_MAX_ORDER + 1], slope[3 * BRICK_MAX_NODES];
    element_basis(&w->plane, at, N2, dN2);
    element_basis(&w->body->line, at + 2, L, dL);
    product(w->n2, w->body->order + 1, N2, dN2, L, dL, slope);
    for (int i = 0; i < w->n; i++) {
        N[i] = N2[i % w->n2] * L[i / w->n2];
    }
    return turn_slopes(w, slope, grad);
}

mat3 brick_mean_jacobian_inverse(const brick *w, double *ratio)
{
    mat3 J = {0}, back;
    double total = 0, volume = 0;
    for (int q = 0; q < w->nq; q++) {
        const mat3 here = jacobian(w, w->slope + 3 * (size_t)q * (size_t)w->n);
        for (int i = 0; i < 9; i++) {
            J.a[i / 3][i % 3] += w->weight[q] * here.a[i / 3][i % 3];
        }
        total += w->weight[q];
        volume += w->dV[q];
    }
    for (int i = 0; i < 9; i++) {
        J.a[i / 3][i % 3] /= total;
    }
    *ratio = invert(J, &back) * total / volume;
    return back;
}
