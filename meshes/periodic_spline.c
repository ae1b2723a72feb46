// meshes/periodic_spline.c
#include "meshes/periodic_spline.h"

#include "base/memory.h"

#include <math.h>

typedef struct row {
    double below, at, above; // of a cyclic tridiagonal matrix
} row;

// Thomas' elimination without the two corners; right: [n], overwritten by the solution; c: [n]
// scratch
static void solve_plain(int n, const row *a, double *right, double *c)
{
    double pivot = a[0].at;
    right[0] /= pivot;
    for (int i = 1; i < n; i++) {
        c[i - 1] = a[i - 1].above / pivot;
        pivot = a[i].at - a[i].below * c[i - 1];
        right[i] = (right[i] - a[i].below * right[i - 1]) / pivot;
    }
    for (int i = n - 2; i >= 0; i--) {
        right[i] -= c[i] * right[i + 1];
    }
}

// The corners by Sherman and Morrison: A = B + u v^T, u = (g, 0 .., a[n-1].above),
// v = (1, 0 .., a[0].below / g). x: [2][n] two right-hand sides.
static status solve_cyclic(int n, row *a, double *x)
{
    status st = OK;
    double *u = NULL, *c = NULL;
    const double g = -a[0].at, low = a[0].below, high = a[n - 1].above;
    TRY(TAKE(u, (size_t)n));
    TRY(TAKE(c, (size_t)n));
    a[0].at -= g;
    a[n - 1].at -= low * high / g;
    u[0] = g;
    u[n - 1] = high;
    solve_plain(n, a, u, c);
    for (int k = 0; k < 2; k++) {
        double *y = x + (size_t)k * (size_t)n;
        solve_plain(n, a, y, c);
        const double factor = (y[0] + low / g * y[n - 1]) / (1 + u[0] + low / g * u[n - 1]);
        for (int i = 0; i < n; i++) {
            y[i] -= factor * u[i];
        }
    }

done:
    free(u);
    free(c);
    return st;
}

// Slopes m with h[i] m[i-1] + 2 (h[i-1] + h[i]) m[i] + h[i-1] m[i+1]
//   = 3 (h[i] d[i-1] + h[i-1] d[i]), d the chords' slopes: the second derivative does not jump
static void set_up(int n, const double *points, const double *h, row *a, double *x)
{
    for (int i = 0; i < n; i++) {
        const int before = (i + n - 1) % n, after = (i + 1) % n;
        a[i] = (row){h[i], 2 * (h[before] + h[i]), h[before]};
        for (int k = 0; k < 2; k++) {
            const double d0 = (points[2 * i + k] - points[2 * before + k]) / h[before];
            const double d1 = (points[2 * after + k] - points[2 * i + k]) / h[i];
            x[k * n + i] = 3 * (h[i] * d0 + h[before] * d1);
        }
    }
}

status periodic_spline_make(int n, const double *points, carrier *piece)
{
    status st = OK;
    double *h = NULL, *m = NULL;
    row *a = NULL;
    TRY(TAKE(h, (size_t)n));
    TRY(TAKE(m, 2 * (size_t)n));
    TRY(TAKE(a, (size_t)n));
    for (int i = 0; i < n; i++) {
        const double *p = points + 2 * i, *q = points + 2 * ((i + 1) % n);
        h[i] = hypot(q[0] - p[0], q[1] - p[1]);
    }
    set_up(n, points, h, a, m);
    TRY(solve_cyclic(n, a, m));
    for (int i = 0; i < n; i++) {
        const int j = (i + 1) % n;
        double p[4][2];
        for (int k = 0; k < 2; k++) {
            p[0][k] = points[2 * i + k];
            p[3][k] = points[2 * j + k];
            p[1][k] = p[0][k] + h[i] / 3 * m[k * n + i];
            p[2][k] = p[3][k] - h[i] / 3 * m[k * n + j];
        }
        piece[i] = carrier_cubic(p[0]);
    }

done:
    free(h);
    free(m);
    free(a);
    return st;
}
