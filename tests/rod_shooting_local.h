// tests/rod_shooting_local.h
// The second method, part 2: the balance of one section,
//
//   K (xi - xi*) + sum tau_i A_i^T t_i = W,  t_i = d_i / |d_i|,  d_i = A_i xi + r_i'
//
// by Newton on its convex energy, docs/theory.md (4.2), (4.3).
#pragma once

#include "tests/rod_shooting_station.h"

// lower triangle; the diagonal holds reciprocals
static inline bool shoot_cholesky(double a[6][6])
{
    for (int j = 0; j < 6; j++) {
        double d = a[j][j];
        for (int k = 0; k < j; k++) {
            d -= a[j][k] * a[j][k];
        }
        if (!(d > 0)) {
            return false;
        }
        a[j][j] = 1 / sqrt(d);
        for (int i = j + 1; i < 6; i++) {
            double sum = a[i][j];
            for (int k = 0; k < j; k++) {
                sum -= a[i][k] * a[j][k];
            }
            a[i][j] = sum * a[j][j];
        }
    }
    return true;
}

static inline void shoot_cholesky_solve(const double a[6][6], double b[6])
{
    for (int i = 0; i < 6; i++) {
        for (int k = 0; k < i; k++) {
            b[i] -= a[i][k] * b[k];
        }
        b[i] *= a[i][i];
    }
    for (int i = 5; i >= 0; i--) {
        for (int k = i + 1; k < 6; k++) {
            b[i] -= a[k][i] * b[k];
        }
        b[i] *= a[i][i];
    }
}

// unit tangent and length of a tendon
static inline double shoot_tangent(const shoot_place *r, const double xi[6], double t[3])
{
    t[0] = xi[0] - xi[5] * r->y + r->dx;
    t[1] = xi[1] + xi[5] * r->x + r->dy;
    t[2] = xi[2] + xi[3] * r->y - xi[4] * r->x;
    const double l = sqrt(t[0] * t[0] + t[1] * t[1] + t[2] * t[2]);
    for (int c = 0; c < 3; c++) {
        t[c] /= l;
    }
    return l;
}

// w += c A^T t
static inline void shoot_add_wrench(const shoot_place *r, double c, const double t[3], double w[6])
{
    w[0] += c * t[0];
    w[1] += c * t[1];
    w[2] += c * t[2];
    w[3] += c * r->y * t[2];
    w[4] -= c * r->x * t[2];
    w[5] += c * (r->x * t[1] - r->y * t[0]);
}

static inline double shoot_energy(const shoot_node *q, int n, const double *tau, const double W[6],
                                  const double xi[6])
{
    double e[6], sum = 0, t[3];
    for (int i = 0; i < 6; i++) {
        e[i] = xi[i] - q->rest[i];
    }
    for (int i = 0; i < 6; i++) {
        double ke = 0;
        for (int j = 0; j < 6; j++) {
            ke += q->K[i][j] * e[j];
        }
        sum += e[i] * (ke / 2 - W[i]);
    }
    for (int i = 0; i < n; i++) {
        sum += tau[i] > 0 ? tau[i] * q->place[i].share * shoot_tangent(&q->place[i], xi, t) : 0;
    }
    return sum;
}

// gradient and Hessian (lower triangle) of the energy
static inline void shoot_gradient(const shoot_node *q, int n, const double *tau, const double W[6],
                                  const double xi[6], double g[6], double H[6][6])
{
    for (int i = 0; i < 6; i++) {
        g[i] = -W[i];
        for (int j = 0; j < 6; j++) {
            g[i] += q->K[i][j] * (xi[j] - q->rest[j]);
            H[i][j] = q->K[i][j];
        }
    }
    for (int k = 0; k < n; k++) {
        const shoot_place *r = &q->place[k];
        const double pull = tau[k] * r->share;
        if (pull <= 0) {
            continue;
        }
        double t[3], at[6] = {0};
        const double f = pull / shoot_tangent(r, xi, t), x = r->x, y = r->y;
        shoot_add_wrench(r, 1, t, at);
        for (int i = 0; i < 6; i++) {
            g[i] += pull * at[i];
            for (int j = 0; j <= i; j++) {
                H[i][j] -= f * at[i] * at[j];
            }
        }
        // f A^T A
        H[0][0] += f;
        H[1][1] += f;
        H[2][2] += f;
        H[3][2] += f * y;
        H[4][2] -= f * x;
        H[5][0] -= f * y;
        H[5][1] += f * x;
        H[3][3] += f * y * y;
        H[4][3] -= f * x * y;
        H[4][4] += f * x * x;
        H[5][5] += f * (x * x + y * y);
    }
}

// xi in and out; H: Cholesky factor of the Hessian there
static inline bool shoot_local(const shoot_node *q, int n, const double *tau, const double W[6],
                               double xi[6], double H[6][6])
{
    // a full step below the first is safe without a look at the energy, one below the second was
    // the last: convergence is quadratic
    static const double calm = 1e-2, done = 3e-9;
    const double arm2 = q->K[3][3] / q->K[2][2];
    for (int step = 0; step < 100; step++) {
        double g[6], d[6];
        shoot_gradient(q, n, tau, W, xi, g, H);
        memcpy(d, g, sizeof d);
        if (!shoot_cholesky(H)) {
            return false;
        }
        shoot_cholesky_solve((const double(*)[6])H, d);
        const double size = sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2] +
                                 arm2 * (d[3] * d[3] + d[4] * d[4] + d[5] * d[5]));
        double slope = 0, part = 1, next[6];
        for (int i = 0; i < 6; i++) {
            slope += g[i] * d[i];
        }
        const double energy = size > calm ? shoot_energy(q, n, tau, W, xi) : 0;
        for (;; part /= 2) {
            for (int i = 0; i < 6; i++) {
                next[i] = xi[i] - part * d[i];
            }
            if (size <= calm || part < 1e-6 ||
                shoot_energy(q, n, tau, W, next) <= energy - 1e-4 * part * slope) {
                break;
            }
        }
        memcpy(xi, next, sizeof next);
        if (!(size < 1e6)) {
            return false;
        }
        if (size < done) {
            return true;
        }
    }
    return false;
}
