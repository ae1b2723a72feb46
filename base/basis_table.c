// base/basis_table.c
// Quadrature rules of the reference elements, and the bases at their points.
#include "base/element.h"

#include "base/memory.h"
#include "base/triangle_rule.h"

#include <stdbool.h>
#include <string.h>

static bool has_triangle_face(const element *e)
{
    return e->shape == SHAPE_TRIANGLE || e->shape == SHAPE_PRISM;
}

// ----------------------------------------------------------------------------------------------------------

enum { MAX_GAUSS = 21 };

static void square_rule(int n, const double *g, const double *w, double (*point)[3], double *weight)
{
    for (int j = 0; j < n; j++) {
        for (int i = 0; i < n; i++) {
            const int k = j * n + i;
            point[k][0] = g[i];
            point[k][1] = g[j];
            weight[k] = w[i] * w[j];
        }
    }
}

// the rule's points and weights in one place; solids repeat the plane rule over the line's points
static int element_rule(const element *e, int degree, double (*point)[3], double *weight)
{
    double g[MAX_GAUSS + 1], w[MAX_GAUSS + 1];
    const int n = degree / 2 + 1;
    gauss_legendre(n, g, w);
    if (e->dim == 1) {
        for (int i = 0; i < n; i++) {
            point[i][0] = g[i];
            weight[i] = w[i];
        }
        return n;
    }
    int nplane = n * n;
    if (has_triangle_face(e)) {
        nplane = triangle_rule(degree, point, weight);
    } else {
        square_rule(n, g, w, point, weight);
    }
    if (e->dim == 2) {
        return nplane;
    }
    for (int k = n - 1; k >= 0; k--) {
        for (int i = 0; i < nplane; i++) {
            double *to = point[k * nplane + i];
            memcpy(to, point[i], 2 * sizeof *to);
            to[2] = g[k];
            weight[k * nplane + i] = weight[i] * w[k];
        }
    }
    return nplane * n;
}

status basis_table_make(const element *e, int degree, basis_table *out)
{
    status st = OK;
    basis_table t = {.dim = e->dim, .nnode = e->nnode};
    double(*point)[3] = NULL;
    double *weight = NULL;

    if (degree < 0 || degree > 2 * (MAX_GAUSS - 1)) {
        TRY(status_fail(ERR_BUG, "no quadrature of degree %d", degree));
    }
    const size_t most = (size_t)(degree / 2 + 2);
    TRY(TAKE(point, most * most * most));
    TRY(TAKE(weight, most * most * most));
    t.npoint = element_rule(e, degree, point, weight);
    TRY(TAKE(t.weight, (size_t)t.npoint));
    TRY(TAKE(t.point, (size_t)(t.npoint * t.dim)));
    TRY(TAKE(t.N, (size_t)(t.npoint * t.nnode)));
    TRY(TAKE(t.dN, (size_t)(t.npoint * t.nnode * t.dim)));
    for (int q = 0; q < t.npoint; q++) {
        t.weight[q] = weight[q];
        memcpy(t.point + q * t.dim, point[q], (size_t)t.dim * sizeof *t.point);
        element_basis(e, point[q], t.N + q * t.nnode, t.dN + q * t.nnode * t.dim);
    }
    *out = t;
    t = (basis_table){0};

done:
    free(point);
    free(weight);
    basis_table_free(&t);
    return st;
}

void basis_table_free(basis_table *table)
{
    free(table->weight);
    free(table->point);
    free(table->N);
    free(table->dN);
    *table = (basis_table){0};
}
