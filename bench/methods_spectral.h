// bench/methods_spectral.h
// Spectral strain: xi is one polynomial over the rod, given by its values at Gauss points; the
// balance holds there, which is Galerkin's method on Legendre polynomials with as many points.
// Poses by steps of order 6 on the interpolant from point to point; one dense Newton on all
// strains.
#pragma once

#include "bench/methods.h"

enum { SPECTRAL_POINTS = 40, SPECTRAL_INNER = 3 };

static const double spectral_inner_at[SPECTRAL_INNER] = {0.1127016653792583, 0.5,
                                                         0.8872983346207417};

typedef struct spectral {
    const rod_spec *spec;
    int n;
    double at[SPECTRAL_POINTS], weight[SPECTRAL_POINTS]; // on [0, L]
    double integral[SPECTRAL_POINTS][SPECTRAL_POINTS]; // int_0^s_i of the j-th Lagrange polynomial
    double inner[SPECTRAL_POINTS + 1][SPECTRAL_INNER][SPECTRAL_POINTS]; // its values between points
    shoot_node node[SPECTRAL_POINTS];
    method_load load;
    pose g[SPECTRAL_POINTS], end;
    double H[SPECTRAL_POINTS][6][6], r[SPECTRAL_POINTS][6], dp[SPECTRAL_POINTS][3],
        M[SPECTRAL_POINTS][3];
    double a[36 * SPECTRAL_POINTS * SPECTRAL_POINTS];
} spectral;

// Gauss' points and weights on [0, 1] by Newton on Legendre's recurrence
static inline void spectral_gauss(int n, double *x, double *w)
{
    for (int i = 0; i < n; i++) {
        double t = cos(3.14159265358979323846 * (i + 0.75) / (n + 0.5)), slope = 1;
        for (int step = 0; step < 8; step++) {
            double p = 1, q = 0;
            for (int k = 1; k <= n; k++) {
                const double next = ((2 * k - 1) * t * p - (k - 1) * q) / k;
                q = p;
                p = next;
            }
            slope = n * (t * p - q) / (t * t - 1);
            t -= p / slope;
        }
        x[n - 1 - i] = (1 + t) / 2;
        w[n - 1 - i] = 1 / ((1 - t * t) * slope * slope);
    }
}

static inline double spectral_lagrange(const spectral *m, int j, double s)
{
    double value = 1;
    for (int k = 0; k < m->n; k++) {
        value *= k == j ? 1 : (s - m->at[k]) / (m->at[j] - m->at[k]);
    }
    return value;
}

static inline void spectral_make(spectral *m, const rod_spec *spec, int n)
{
    const double L = spec->law->length;
    double x[SPECTRAL_POINTS], w[SPECTRAL_POINTS];
    m->spec = spec;
    m->n = n;
    spectral_gauss(n, x, w);
    for (int i = 0; i < n; i++) {
        m->at[i] = L * x[i];
        m->weight[i] = L * w[i];
        shoot_node_make(spec, m->at[i], &m->node[i]);
    }
    for (int j = 0; j < n; j++) {
        for (int i = 0; i < n; i++) {
            m->integral[i][j] = 0;
            for (int k = 0; k < n; k++) {
                m->integral[i][j] += x[i] * m->weight[k] * spectral_lagrange(m, j, x[i] * m->at[k]);
            }
        }
        for (int i = 0; i <= n; i++) {
            const double from = i == 0 ? 0 : m->at[i - 1], to = i == n ? L : m->at[i];
            for (int k = 0; k < SPECTRAL_INNER; k++) {
                m->inner[i][k][j] =
                    spectral_lagrange(m, j, from + (to - from) * spectral_inner_at[k]);
            }
        }
    }
}

// Omega of order 6 from three Gauss points (Blanes, Casas and Ros, BIT 40), g' = g hat(xi)
static inline vec6 spectral_step(double h, const vec6 xi[SPECTRAL_INNER])
{
    const vec6 a = vec6_scale(h, xi[1]);
    const vec6 b = vec6_scale(sqrt(15.0) / 3 * h, vec6_sub(xi[2], xi[0]));
    const vec6 c = vec6_scale(10.0 / 3 * h, vec6_add(vec6_sub(xi[2], vec6_scale(2, xi[1])), xi[0]));
    const vec6 d = vec6_scale(-1, se3_bracket(a, b));
    const vec6 e = vec6_scale(1.0 / 60, se3_bracket(a, vec6_add(vec6_scale(2, c), d)));
    const vec6 f = vec6_sub(vec6_add(vec6_scale(-20, a), vec6_scale(-1, c)), vec6_scale(-1, d));
    const vec6 last = vec6_scale(-1.0 / 240, se3_bracket(f, vec6_add(b, e)));
    return vec6_add(vec6_add(a, vec6_scale(1.0 / 12, c)), last);
}

static inline void spectral_poses(spectral *m, const double *x)
{
    const double L = m->spec->law->length;
    pose g = pose_identity();
    for (int i = 0; i <= m->n; i++) {
        const double from = i == 0 ? 0 : m->at[i - 1], to = i == m->n ? L : m->at[i];
        vec6 xi[SPECTRAL_INNER] = {0};
        for (int k = 0; k < SPECTRAL_INNER; k++) {
            for (int j = 0; j < m->n; j++) {
                for (int c = 0; c < 6; c++) {
                    xi[k].a[c] += m->inner[i][k][j] * x[6 * j + c];
                }
            }
        }
        g = pose_mul(g, se3_exp(spectral_step(to - from, xi)));
        if (i < m->n) {
            m->g[i] = g;
        }
    }
    m->end = g;
}

// misfits of the balance and their own tangents; the squared size, in strains
static inline double spectral_misfit(spectral *m, double lambda, const double *x)
{
    double tau[3], F[3], size = 0;
    for (int i = 0; i < 3; i++) {
        tau[i] = lambda * m->load.tension[i];
        F[i] = lambda * m->load.force[i];
    }
    spectral_poses(m, x);
    for (int i = 0; i < m->n; i++) {
        const double *R = &m->g[i].R.a[0][0];
        const vec3 arm = vec3_sub(m->end.p, m->g[i].p);
        double W[6];
        shoot_cross(arm.a, F, m->M[i]);
        shoot_unturn(R, F, W);
        shoot_unturn(R, m->M[i], W + 3);
        shoot_turn(R, x + 6 * i, m->dp[i]);
        shoot_gradient(&m->node[i], 3, tau, W, x + 6 * i, m->r[i], m->H[i]);
        for (int c = 0; c < 6; c++) {
            const double e = m->r[i][c] / m->node[i].K[c][c] * (c < 3 ? 1 : 3e-3);
            size += m->weight[i] * e * e;
            for (int d = 0; d < c; d++) {
                m->H[i][d][c] = m->H[i][c][d];
            }
        }
    }
    return size;
}

// adds the tangent of -W at point i by what strain j does to it: phi_i, and the arm to the tip
static inline void spectral_block(const spectral *m, const double F[3], int i, int j,
                                  const double lever[3][3], double *block, int row)
{
    const double *R = &m->g[i].R.a[0][0], *Rj = &m->g[j].R.a[0][0];
    const double S = m->integral[i][j], T = m->weight[j] - S;
    for (int c = 0; c < 6; c++) {
        double phi[3] = {0}, arm[3] = {0}, a[3], b[3], n[3], W[6];
        for (int k = 0; k < 3; k++) {
            const double column = Rj[3 * k + c % 3];
            phi[k] = c < 3 ? 0 : S * column;
            arm[k] = c < 3 ? T * column : 0;
        }
        if (c >= 3) {
            const double column[3] = {Rj[c % 3], Rj[3 + c % 3], Rj[6 + c % 3]};
            for (int k = 0; k < 3; k++) {
                arm[k] =
                    lever[k][0] * column[0] + lever[k][1] * column[1] + lever[k][2] * column[2];
            }
        }
        shoot_cross(F, phi, n);
        shoot_cross(arm, F, a);
        shoot_cross(m->M[i], phi, b);
        for (int k = 0; k < 3; k++) {
            a[k] += b[k];
        }
        shoot_unturn(R, n, W);
        shoot_unturn(R, a, W + 3);
        for (int k = 0; k < 6; k++) {
            block[k * row + c] -= W[k];
        }
    }
}

// d(arm to the tip at i) = sum_k T_ik phi_k x p'_k, phi_k = sum_j S_kj R_j dw_j
static inline void spectral_lever(const spectral *m, int i, int j, double lever[3][3])
{
    double q[3] = {0};
    for (int k = 0; k < m->n; k++) {
        const double f = (m->weight[k] - m->integral[i][k]) * m->integral[k][j];
        for (int c = 0; c < 3; c++) {
            q[c] += f * m->dp[k][c];
        }
    }
    const mat3 hat = mat3_hat((vec3){{-q[0], -q[1], -q[2]}});
    memcpy(lever, hat.a, sizeof hat.a);
}

static inline bool spectral_change(spectral *m, double lambda, double *d)
{
    const int n = 6 * m->n;
    double F[3], lever[3][3];
    for (int k = 0; k < 3; k++) {
        F[k] = lambda * m->load.force[k];
    }
    memset(m->a, 0, (size_t)(n * n) * sizeof *m->a);
    for (int i = 0; i < m->n; i++) {
        for (int j = 0; j < m->n; j++) {
            spectral_lever(m, i, j, lever);
            spectral_block(m, F, i, j, (const double(*)[3])lever, m->a + 6 * i * n + 6 * j, n);
        }
        for (int k = 0; k < 36; k++) {
            m->a[(6 * i + k / 6) * n + 6 * i + k % 6] += m->H[i][k / 6][k % 6];
        }
        for (int c = 0; c < 6; c++) {
            d[6 * i + c] = -m->r[i][c];
        }
    }
    return method_solve(n, m->a, d);
}

static inline bool spectral_newton(void *self, double lambda, double *x, int *steps)
{
    spectral *m = self;
    double d[6 * SPECTRAL_POINTS], next[6 * SPECTRAL_POINTS];
    double size = spectral_misfit(m, lambda, x), trial = 0;
    for (int step = 0; step < METHOD_MOST_STEPS; step++) {
        double largest = 0, part = 1;
        ++*steps;
        if (!spectral_change(m, lambda, d)) {
            return false;
        }
        for (int i = 0; i < 6 * m->n; i++) {
            // curvatures count by the rod's length
            largest = fmax(largest, fabs(d[i]) * (i % 6 < 3 ? 1 : m->spec->law->length));
        }
        for (;; part /= 2) {
            for (int i = 0; i < 6 * m->n; i++) {
                next[i] = x[i] + part * d[i];
            }
            trial = spectral_misfit(m, lambda, next);
            if (trial < size || largest < method_last) {
                break;
            }
            if (part < 1e-3) {
                return false;
            }
        }
        size = trial;
        memcpy(x, next, sizeof *x * 6 * (size_t)m->n);
        if (largest < method_last) {
            return true;
        }
    }
    return false;
}

static inline void spectral_rest(void *self, double *x)
{
    const spectral *m = self;
    for (int i = 0; i < m->n; i++) {
        memcpy(x + 6 * i, m->node[i].rest, 6 * sizeof *x);
    }
}

static inline void spectral_load(void *self, const method_load *load)
{
    ((spectral *)self)->load = *load;
}

static inline void spectral_guess(void *self, double *x)
{
    const spectral *m = self;
    const double W[6] = {0};
    double H[6][6];
    for (int i = 0; i < m->n; i++) {
        (void)shoot_local(&m->node[i], 3, m->load.tension, W, x + 6 * i, H);
    }
}

static inline void spectral_extend(const void *self, const double *a, const double *b, double t,
                                   double *x)
{
    method_extend_linearly(6 * ((const spectral *)self)->n, a, b, t, x);
}

static inline vec3 spectral_tip(void *self, double lambda, const double *x)
{
    spectral *m = self;
    (void)lambda;
    spectral_poses(m, x);
    return m->end.p;
}

static inline method spectral_method(spectral *m)
{
    return (method){.name = "spectral strain",
                    .n = 6 * m->n,
                    .rest = spectral_rest,
                    .load = spectral_load,
                    .guess = spectral_guess,
                    .newton = spectral_newton,
                    .extend = spectral_extend,
                    .tip = spectral_tip,
                    .self = m};
}
