// bench/methods.h
// What the methods compared by bench_methods share: a rod under tendons and a dead tip force, as
// unknowns that Newton improves at a part lambda of the load, and one continuation for all.
#pragma once

#include "tests/rod_shooting_more.h"

enum { METHOD_UNKNOWNS = 512, METHOD_MOST_STEPS = 25 };

typedef struct method_load {
    double tension[3], force[3];
} method_load;

typedef struct method {
    const char *name;
    int n;                               // unknowns
    void (*rest)(void *self, double *x); // of the unloaded rod
    void (*load)(void *self, const method_load *load);
    void (*guess)(void *self, double *x); // bent by its tendons alone, not by the force
    // from x to the equilibrium at lambda; adds its steps to *steps. false: no convergence
    bool (*newton)(void *self, double lambda, double *x, int *steps);
    // x beyond b as far as t times from a to b
    void (*extend)(const void *self, const double *a, const double *b, double t, double *x);
    vec3 (*tip)(void *self, double lambda, const double *x);
    void *self;
} method;

// |d| small enough for the last step: convergence is quadratic, in units of order 1
static const double method_last = 1e-5;

static inline void method_extend_linearly(int n, const double *a, const double *b, double t,
                                          double *x)
{
    for (int i = 0; i < n; i++) {
        x[i] = b[i] + t * (b[i] - a[i]);
    }
}

// straight to the whole load, from the rod that its tendons bend
static inline bool method_at_once(const method *m, const method_load *load, double *x, int *steps)
{
    m->load(m->self, load);
    m->rest(m->self, x);
    m->guess(m->self, x);
    return m->newton(m->self, 1, x, steps);
}

// lambda from 0 to 1 on tensions and force together, the secant as guess
static inline bool method_by_steps(const method *m, const method_load *load, double *x, int *steps)
{
    enum { QUICK = 4 };
    const double first = 0.25, shortest = 1e-5;
    static double a[METHOD_UNKNOWNS], b[METHOD_UNKNOWNS];
    double at = 0, before = 0, step = first;
    m->load(m->self, load);
    m->rest(m->self, b);
    memcpy(a, b, sizeof a);
    while (at < 1) {
        const double next = fmin(1, at + step);
        const int start = *steps;
        m->extend(m->self, a, b, at > before ? (next - at) / (at - before) : 0, x);
        if (!m->newton(m->self, next, x, steps)) {
            step = (next - at) / 2;
            if (step < shortest) {
                return false;
            }
            continue;
        }
        step = *steps - start <= QUICK ? 2 * step : step;
        memcpy(a, b, sizeof a);
        memcpy(b, x, (size_t)m->n * sizeof *b);
        before = at;
        at = next;
    }
    return true;
}

// Gauss with pivoting in place, b becomes the solution; false where it is singular
static inline bool method_solve(int n, double *a, double *b)
{
    for (int k = 0; k < n; k++) {
        int best = k;
        for (int i = k + 1; i < n; i++) {
            best = fabs(a[i * n + k]) > fabs(a[best * n + k]) ? i : best;
        }
        if (!(fabs(a[best * n + k]) > 0)) {
            return false;
        }
        for (int j = 0; j < n && best != k; j++) {
            const double swap = a[k * n + j];
            a[k * n + j] = a[best * n + j];
            a[best * n + j] = swap;
        }
        const double swap = b[k];
        b[k] = b[best];
        b[best] = swap;
        for (int i = k + 1; i < n; i++) {
            const double f = a[i * n + k] / a[k * n + k];
            if (f != 0) {
                b[i] -= f * b[k];
                for (int j = k; j < n; j++) {
                    a[i * n + j] -= f * a[k * n + j];
                }
            }
        }
    }
    for (int i = n - 1; i >= 0; i--) {
        for (int j = i + 1; j < n; j++) {
            b[i] -= a[i * n + j] * b[j];
        }
        b[i] /= a[i * n + i];
    }
    return true;
}
