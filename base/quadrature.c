// base/quadrature.c
// Gauss and Gauss-Lobatto points by Newton's method on Legendre polynomials.
#include "base/element.h"

#include <math.h>

enum { NEWTON_STEPS = 100 };

// P_n(x) and its derivative
static void legendre(int n, double x, double *p, double *dp)
{
    double before = 1, now = x;
    for (int k = 2; k <= n; k++) {
        const double next = ((2 * k - 1) * x * now - (k - 1) * before) / k;
        before = now;
        now = next;
    }
    *p = n == 0 ? 1 : now;
    *dp = n == 0 ? 0 : n * (before - x * now) / (1 - x * x);
}

void gauss_legendre(int n, double *x, double *w)
{
    const double pi = acos(-1.0);
    for (int i = 0; i < n; i++) {
        double t = -cos(pi * (i + 0.75) / (n + 0.5)), p, dp;
        for (int k = 0; k < NEWTON_STEPS; k++) {
            legendre(n, t, &p, &dp);
            const double step = p / dp;
            t -= step;
            if (fabs(step) < 1e-15) {
                break;
            }
        }
        legendre(n, t, &p, &dp);
        x[i] = t;
        w[i] = 2 / ((1 - t * t) * dp * dp);
    }
    if (n % 2 == 1) {
        x[n / 2] = 0;
    }
}

void gauss_lobatto_nodes(int n, double *x)
{
    const double pi = acos(-1.0);
    const int degree = n - 1;
    x[0] = -1;
    x[degree] = 1;
    // the inner nodes are the zeros of P'_degree; (1 - t^2) P'' = 2 t P' - degree (degree + 1) P
    for (int i = 1; i < degree; i++) {
        double t = -cos(pi * i / degree);
        for (int k = 0; k < NEWTON_STEPS; k++) {
            double p, dp;
            legendre(degree, t, &p, &dp);
            const double ddp = (2 * t * dp - degree * (degree + 1) * p) / (1 - t * t);
            const double step = dp / ddp;
            t -= step;
            if (fabs(step) < 1e-15) {
                break;
            }
        }
        x[i] = t;
    }
    if (degree % 2 == 0) {
        x[degree / 2] = 0;
    }
}
