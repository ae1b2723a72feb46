// base/element.c
#include "base/element.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

// --- nodes
// ---------------------------------------------------------------------------------------------------------

int element_dim(shape shape)
{
    switch (shape) {
    case SHAPE_LINE:
        return 1;
    case SHAPE_TRIANGLE:
    case SHAPE_QUAD:
        return 2;
    case SHAPE_PRISM:
    case SHAPE_HEX:
        return 3;
    }
    return 0;
}

int element_node_count(shape shape, int order)
{
    const int line = order + 1, triangle = (order + 1) * (order + 2) / 2;
    switch (shape) {
    case SHAPE_LINE:
        return line;
    case SHAPE_TRIANGLE:
        return triangle;
    case SHAPE_QUAD:
        return line * line;
    case SHAPE_PRISM:
        return triangle * line;
    case SHAPE_HEX:
        return line * line * line;
    }
    return 0;
}

const char *shape_name(shape shape)
{
    static const char *const names[] = {"line", "triangle", "quad", "prism", "hex"};
    return names[shape];
}

static bool has_triangle_face(shape shape)
{
    return shape == SHAPE_TRIANGLE || shape == SHAPE_PRISM;
}

// x = (1 + 2 v_i - v_j - v_k) / 3 with Lobatto points v on [0,1]: on an edge it is the Lobatto
// point itself
static int triangle_nodes(const element *e, double (*node)[3])
{
    const int p = e->order;
    int n = 0;
    for (int j = 0; j <= p; j++) {
        for (int i = 0; i <= p - j; i++, n++) {
            const double u = (e->line_node[i] + 1) / 2, v = (e->line_node[j] + 1) / 2,
                         w = (e->line_node[p - i - j] + 1) / 2;
            node[n][0] = (1 + 2 * u - v - w) / 3;
            node[n][1] = (1 + 2 * v - u - w) / 3;
        }
    }
    return n;
}

static int quad_nodes(const element *e, double (*node)[3])
{
    int n = 0;
    for (int j = 0; j <= e->order; j++) {
        for (int i = 0; i <= e->order; i++, n++) {
            node[n][0] = e->line_node[i];
            node[n][1] = e->line_node[j];
        }
    }
    return n;
}

static void place_nodes(element *e)
{
    if (e->dim == 1) {
        for (int i = 0; i <= e->order; i++) {
            e->node[i][0] = e->line_node[i];
        }
        return;
    }
    const int plane =
        has_triangle_face(e->shape) ? triangle_nodes(e, e->node) : quad_nodes(e, e->node);
    for (int k = e->dim == 3 ? e->order : 0; k >= 0; k--) {
        for (int i = 0; i < plane; i++) {
            double *to = e->node[k * plane + i];
            memcpy(to, e->node[i], 2 * sizeof *to);
            to[2] = e->dim == 3 ? e->line_node[k] : 0;
        }
    }
}

// --- triangle basis: Bernstein polynomials, combined so that each is 1 at its node
// -----------------------------------

static const double factorial[] = {1, 1, 2, 6, 24};

// a^n, a >= 0 integer powers up to the order
static void powers(double a, int order, double *out)
{
    out[0] = 1;
    for (int i = 1; i <= order; i++) {
        out[i] = out[i - 1] * a;
    }
}

static void bernstein_basis(int p, double x, double y, double *B, double *dB)
{
    double px[5], py[5], pz[5];
    powers(x, p, px);
    powers(y, p, py);
    powers(1 - x - y, p, pz);
    int n = 0;
    for (int j = 0; j <= p; j++) {
        for (int i = 0; i <= p - j; i++, n++) {
            const int k = p - i - j;
            const double c = factorial[p] / (factorial[i] * factorial[j] * factorial[k]);
            B[n] = c * px[i] * py[j] * pz[k];
            const double di = i ? i * px[i - 1] * py[j] * pz[k] : 0;
            const double dj = j ? j * px[i] * py[j - 1] * pz[k] : 0;
            const double dk = k ? k * px[i] * py[j] * pz[k - 1] : 0;
            dB[2 * n] = c * (di - dk);
            dB[2 * n + 1] = c * (dj - dk);
        }
    }
}

// Gauss-Jordan with pivoting, n <= 15; false when singular
static bool invert(int n, double (*a)[15], double (*inverse)[15])
{
    for (int i = 0; i < n; i++) {
        for (int j = 0; j < n; j++) {
            inverse[i][j] = i == j;
        }
    }
    for (int c = 0; c < n; c++) {
        int pivot = c;
        for (int r = c + 1; r < n; r++) {
            pivot = fabs(a[r][c]) > fabs(a[pivot][c]) ? r : pivot;
        }
        if (a[pivot][c] == 0) {
            return false;
        }
        for (int j = 0; j < n; j++) {
            const double t = a[c][j], u = inverse[c][j];
            a[c][j] = a[pivot][j];
            a[pivot][j] = t;
            inverse[c][j] = inverse[pivot][j];
            inverse[pivot][j] = u;
        }
        const double d = a[c][c];
        for (int j = 0; j < n; j++) {
            a[c][j] /= d;
            inverse[c][j] /= d;
        }
        for (int r = 0; r < n; r++) {
            const double f = r == c ? 0 : a[r][c];
            for (int j = 0; j < n; j++) {
                a[r][j] -= f * a[c][j];
                inverse[r][j] -= f * inverse[c][j];
            }
        }
    }
    return true;
}

static status make_triangle_basis(element *e)
{
    const int n = element_node_count(SHAPE_TRIANGLE, e->order);
    double vandermonde[15][15] = {{0}};
    for (int i = 0; i < n; i++) {
        double dB[30];
        bernstein_basis(e->order, e->node[i][0], e->node[i][1], vandermonde[i], dB);
    }
    if (!invert(n, vandermonde, e->bernstein)) {
        return status_fail(ERR_BUG, "triangle of order %d has no basis", e->order);
    }
    return OK;
}

static void triangle_basis(const element *e, const double *x, double *N, double *dN)
{
    const int n = element_node_count(SHAPE_TRIANGLE, e->order);
    double B[15], dB[30];
    bernstein_basis(e->order, x[0], x[1], B, dB);
    for (int i = 0; i < n; i++) {
        double v = 0, dx = 0, dy = 0;
        for (int k = 0; k < n; k++) {
            v += B[k] * e->bernstein[k][i];
            dx += dB[2 * k] * e->bernstein[k][i];
            dy += dB[2 * k + 1] * e->bernstein[k][i];
        }
        N[i] = v;
        dN[2 * i] = dx;
        dN[2 * i + 1] = dy;
    }
}

// --- line, and products of it
// ----------------------------------------------------------------------------------------

static void line_basis(const element *e, double x, double *N, double *dN)
{
    const int n = e->order + 1;
    const double *t = e->line_node;
    for (int i = 0; i < n; i++) {
        double value = 1, slope = 0;
        for (int k = 0; k < n; k++) {
            if (k != i) {
                const double d = t[i] - t[k];
                slope = (slope * (x - t[k]) + value) / d;
                value *= (x - t[k]) / d;
            }
        }
        N[i] = value;
        dN[i] = slope;
    }
}

static void quad_basis(const element *e, const double *x, double *N, double *dN)
{
    double a[5], da[5], b[5], db[5];
    line_basis(e, x[0], a, da);
    line_basis(e, x[1], b, db);
    int n = 0;
    for (int j = 0; j <= e->order; j++) {
        for (int i = 0; i <= e->order; i++, n++) {
            N[n] = a[i] * b[j];
            dN[2 * n] = da[i] * b[j];
            dN[2 * n + 1] = a[i] * db[j];
        }
    }
}

// prism and hex: (plane basis) x (line basis)
static void solid_basis(const element *e, const double *x, double *N, double *dN)
{
    double plane[ELEMENT_MAX_PLANE_NODES], dplane[2 * ELEMENT_MAX_PLANE_NODES], c[5], dc[5];
    if (e->shape == SHAPE_PRISM) {
        triangle_basis(e, x, plane, dplane);
    } else {
        quad_basis(e, x, plane, dplane);
    }
    line_basis(e, x[2], c, dc);
    const int nplane = e->nnode / (e->order + 1);
    for (int k = 0; k <= e->order; k++) {
        for (int i = 0; i < nplane; i++) {
            const int n = k * nplane + i;
            N[n] = plane[i] * c[k];
            dN[3 * n] = dplane[2 * i] * c[k];
            dN[3 * n + 1] = dplane[2 * i + 1] * c[k];
            dN[3 * n + 2] = plane[i] * dc[k];
        }
    }
}

void element_basis(const element *e, const double *x, double *N, double *dN)
{
    double spare[3 * ELEMENT_MAX_NODES];
    double *d = dN ? dN : spare;
    switch (e->shape) {
    case SHAPE_LINE:
        line_basis(e, x[0], N, d);
        break;
    case SHAPE_TRIANGLE:
        triangle_basis(e, x, N, d);
        break;
    case SHAPE_QUAD:
        quad_basis(e, x, N, d);
        break;
    case SHAPE_PRISM:
    case SHAPE_HEX:
        solid_basis(e, x, N, d);
        break;
    }
}

status element_make(shape shape, int order, element *out)
{
    if (order < 1 || order > ELEMENT_MAX_ORDER) {
        return status_fail(ERR_BUG, "element order %d is not 1 to %d", order, ELEMENT_MAX_ORDER);
    }
    *out = (element){.shape = shape, .order = order, .dim = element_dim(shape)};
    out->nnode = element_node_count(shape, order);
    gauss_lobatto_nodes(order + 1, out->line_node);
    place_nodes(out);
    return has_triangle_face(shape) ? make_triangle_basis(out) : OK;
}
