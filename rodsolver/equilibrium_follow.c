// rodsolver/equilibrium_follow.c
// The linear answer when tensions follow it by friction. With K^-1 what pull_solve does at tensions
// that stay, and P what friction adds, (K + P) x = -b is x - G x = x0 with G = -K^-1 P: an integral
// along the paths, so that the Krylov spaces of few vectors hold the answer. docs/theory.md (4.26)
#include "rodsolver/equilibrium_path.h"

#include <math.h>
#include <string.h>

enum { VECTORS = FRICTION_VECTORS, CYCLES = 3 };

typedef struct krylov {
    double H[VECTORS][VECTORS + 1]; // column after column, turned to a triangle
    double c[VECTORS], s[VECTORS];  // the rotations that do so
    double rhs[VECTORS + 1];
} krylov;

static vec6 *basis_vector(const equilibrium *e, int k)
{
    return e->follow.basis + (size_t)k * (size_t)e->room;
}

static void add_scaled(const equilibrium *e, double c, const vec6 *x, vec6 *y)
{
    for (int i = 0; i < e->plan->nstation; i++) {
        y[i] = vec6_add(y[i], vec6_scale(c, x[i]));
    }
}

static void scale(const equilibrium *e, double c, vec6 *x)
{
    for (int i = 0; i < e->plan->nstation; i++) {
        x[i] = vec6_scale(c, x[i]);
    }
}

static double norm(const equilibrium *e, const vec6 *x)
{
    return sqrt(path_product(e, x, x));
}

// y = x - G x
static void apply(equilibrium *e, const vec6 *x, vec6 *y)
{
    const size_t n = (size_t)e->plan->nstation;
    memset(e->rv, 0, n * sizeof *e->rv);
    memset(e->rw, 0, n * sizeof *e->rw);
    memset(e->follow.change, 0, (size_t)e->rod->ntendon * sizeof(double));
    friction_misfits(e, x, e->follow.change);
    pull_solve(e, e->follow.change, y);
    scale(e, -1, y);
    add_scaled(e, 1, x, y);
}

static void rotate(double c, double s, double *a, double *b)
{
    const double x = c * *a + s * *b;
    *b = c * *b - s * *a;
    *a = x;
}

// the k-th column made triangular; what is left of the right-hand side
static double triangular(krylov *g, int k)
{
    double *h = g->H[k];
    for (int i = 0; i < k; i++) {
        rotate(g->c[i], g->s[i], &h[i], &h[i + 1]);
    }
    const double size = hypot(h[k], h[k + 1]);
    g->c[k] = size > 0 ? h[k] / size : 1;
    g->s[k] = size > 0 ? h[k + 1] / size : 0;
    rotate(g->c[k], g->s[k], &h[k], &h[k + 1]);
    g->rhs[k + 1] = 0;
    rotate(g->c[k], g->s[k], &g->rhs[k], &g->rhs[k + 1]);
    return fabs(g->rhs[k + 1]);
}

// GMRES: basis_vector(0) is the right-hand side; the answer is added to x
static void minimise(equilibrium *e, double wanted, vec6 *x)
{
    krylov g;
    int n = 0;
    double left = norm(e, basis_vector(e, 0));
    g.rhs[0] = left;
    scale(e, 1 / left, basis_vector(e, 0));
    while (n < VECTORS && left > wanted) {
        vec6 *next = basis_vector(e, n + 1);
        apply(e, basis_vector(e, n), next);
        for (int i = 0; i <= n; i++) {
            g.H[n][i] = path_product(e, next, basis_vector(e, i));
            add_scaled(e, -g.H[n][i], basis_vector(e, i), next);
        }
        g.H[n][n + 1] = norm(e, next);
        scale(e, g.H[n][n + 1] > 0 ? 1 / g.H[n][n + 1] : 0, next);
        left = triangular(&g, n);
        n++;
    }
    for (int k = n - 1; k >= 0; k--) {
        g.rhs[k] /= g.H[k][k];
        add_scaled(e, g.rhs[k], basis_vector(e, k), x);
        for (int i = 0; i < k; i++) {
            g.rhs[i] -= g.H[k][i] * g.rhs[k];
        }
    }
}

// the answer to the right-hand side kept and to tensions that follow x
static void answer_to(equilibrium *e, const vec6 *x, double *change, vec6 *strain)
{
    const size_t n = (size_t)e->plan->nstation;
    memcpy(e->rv, e->follow.v, n * sizeof *e->rv);
    memcpy(e->rw, e->follow.w, n * sizeof *e->rw);
    memcpy(change, e->follow.given, (size_t)e->rod->ntendon * sizeof *change);
    friction_misfits(e, x, change);
    pull_solve(e, change, strain);
}

bool friction_solve(equilibrium *e, double tolerance, double *change, vec6 *strain)
{
    if (!friction_follows(e)) {
        pull_solve(e, change, strain);
        return true;
    }
    const size_t n = (size_t)e->plan->nstation;
    vec6 *x = e->follow.x, *residual = basis_vector(e, 0);
    memcpy(e->follow.v, e->rv, n * sizeof *e->rv);
    memcpy(e->follow.w, e->rw, n * sizeof *e->rw);
    memcpy(e->follow.given, change, (size_t)e->rod->ntendon * sizeof *change);
    memset(x, 0, n * sizeof *x);
    for (int k = 0; k < CYCLES; k++) {
        answer_to(e, x, change, strain);
        memcpy(residual, strain, n * sizeof *strain);
        add_scaled(e, -1, x, residual);
        const double size = norm(e, strain), left = norm(e, residual);
        if (!isfinite(size + left)) {
            return false;
        }
        if (left <= tolerance * size) {
            return true;
        }
        minimise(e, 0.3 * tolerance * size, x);
    }
    return false;
}
