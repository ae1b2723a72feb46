// measure/tube_curve.c
#include "measure/tube_inside.h"

#include "base/memory.h"

#include <stdlib.h>
#include <string.h>

status tube_curve_make(const gsl_spline_door *door, int npiece, double length, tube_curve *out)
{
    status st = OK;
    tube_curve c = {
        .door = door, .npiece = npiece, .ncoef = npiece + TUBE_ORDER - 1, .length = length};
    TRY(TAKE(c.taylor, (size_t)npiece * TUBE_ORDER * TUBE_ORDER));
    TRY(TAKE(c.coef, (size_t)c.ncoef));
    TRY(TAKE(c.power, (size_t)npiece));
    TRY(door->pieces(TUBE_ORDER, npiece, length, c.taylor));
    *out = c;
    c = (tube_curve){0};

done:
    tube_curve_free(&c);
    return st;
}

void tube_curve_free(tube_curve *c)
{
    free(c->taylor);
    free(c->coef);
    free(c->power);
    *c = (tube_curve){0};
}

int tube_curve_piece(const tube_curve *c, double u, double *x)
{
    const double h = c->length / c->npiece;
    const int i = u <= 0 ? 0 : u >= c->length ? c->npiece - 1 : (int)(u / h);
    const int piece = i < c->npiece ? i : c->npiece - 1;
    *x = u - (piece + 0.5) * h;
    return piece;
}

void tube_curve_set(tube_curve *c)
{
    for (int i = 0; i < c->npiece; i++) {
        const double *taylor = c->taylor + (size_t)i * TUBE_ORDER * TUBE_ORDER;
        memset(c->power[i], 0, sizeof c->power[i]);
        for (int k = 0; k < TUBE_ORDER; k++) {
            for (int m = 0; m < TUBE_ORDER; m++) {
                for (int d = 0; d < 3; d++) {
                    c->power[i][m][d] += taylor[k * TUBE_ORDER + m] * c->coef[i + k][d];
                }
            }
        }
    }
}

void tube_curve_basis(const tube_curve *c, int piece, double x, int derivative, double *b)
{
    for (int k = 0; k < TUBE_ORDER; k++) {
        const double *a = c->taylor + ((size_t)piece * TUBE_ORDER + (size_t)k) * TUBE_ORDER;
        b[k] = 0;
        for (int m = TUBE_ORDER - 1; m >= derivative; m--) {
            double factor = 1;
            for (int j = 0; j < derivative; j++) {
                factor *= m - j;
            }
            b[k] = b[k] * x + factor * a[m];
        }
    }
}

vec3 tube_curve_at(const tube_curve *c, double u, vec3 *d1, vec3 *d2)
{
    double x = 0;
    const double(*a)[3] = (const double(*)[3])c->power[tube_curve_piece(c, u, &x)];
    vec3 p = {{0, 0, 0}}, v = p, w = p;
    for (int m = TUBE_ORDER - 1; m >= 0; m--) {
        for (int d = 0; d < 3; d++) {
            w.a[d] = w.a[d] * x + 2 * v.a[d];
            v.a[d] = v.a[d] * x + p.a[d];
            p.a[d] = p.a[d] * x + a[m][d];
        }
    }
    if (d1) {
        *d1 = v;
    }
    if (d2) {
        *d2 = w;
    }
    return p;
}

double tube_curve_foot(const tube_curve *c, vec3 q, double u, int steps)
{
    for (int i = 0; i < steps; i++) {
        vec3 d1, d2;
        const vec3 v = vec3_sub(tube_curve_at(c, u, &d1, &d2), q);
        const double square = vec3_dot(d1, d1), curved = square + vec3_dot(v, d2);
        const double du = -vec3_dot(v, d1) / fmax(curved, 0.3 * square);
        const double most = 2 * c->length / c->npiece;
        u += fmax(-most, fmin(most, du));
        if (u < -most || u > c->length + most) {
            break;
        }
    }
    return u;
}

void tube_curve_gram(const tube_curve *c, int derivative, double weight, double *P)
{
    // five points of Gauss: products of two quintics
    const double at[5] = {0, 0.5384693101056831, -0.5384693101056831, 0.9061798459386640,
                          -0.9061798459386640};
    const double share[5] = {128 / 225.0, 0.4786286704993665, 0.4786286704993665,
                             0.2369268850561891, 0.2369268850561891};
    const double h = c->length / c->npiece;
    for (int i = 0; i < c->npiece; i++) {
        for (int g = 0; g < 5; g++) {
            double b[TUBE_ORDER];
            tube_curve_basis(c, i, at[g] * h / 2, derivative, b);
            for (int k = 0; k < TUBE_ORDER * TUBE_ORDER; k++) {
                const int row = i + k / TUBE_ORDER, column = i + k % TUBE_ORDER;
                P[row * c->ncoef + column] +=
                    weight * share[g] * h / 2 * b[k / TUBE_ORDER] * b[k % TUBE_ORDER];
            }
        }
    }
}

// B^T B and B^T p of the places; one right side after the other
static void places_normal(const tube_curve *c, int n, const double *u, const vec3 *p, int axis,
                          double *a, double *g)
{
    for (int i = 0; i < n; i++) {
        double x = 0, b[TUBE_ORDER];
        const int piece = tube_curve_piece(c, u[i], &x);
        tube_curve_basis(c, piece, x, 0, b);
        for (int k = 0; k < TUBE_ORDER; k++) {
            g[piece + k] += b[k] * p[i].a[axis];
            for (int l = 0; l < TUBE_ORDER; l++) {
                a[(piece + k) * c->ncoef + piece + l] += b[k] * b[l];
            }
        }
    }
}

status tube_curve_through(tube_curve *c, int n, const double *u, const vec3 *p, double smoothing)
{
    status st = OK;
    const size_t m = (size_t)c->ncoef;
    double *a = NULL, *g = NULL;
    TRY(TAKE(a, m * m));
    TRY(TAKE(g, m));
    for (int d = 0; d < 3; d++) {
        memset(a, 0, m * m * sizeof *a);
        memset(g, 0, m * sizeof *g);
        places_normal(c, n, u, p, d, a, g);
        tube_curve_gram(c, 3, n / c->length * pow(smoothing, 6), a);
        TRY(c->door->solve(c->ncoef, a, g, false));
        for (size_t k = 0; k < m; k++) {
            c->coef[k][d] = g[k];
        }
    }
    tube_curve_set(c);

done:
    free(a);
    free(g);
    return st;
}

enum { CUT_PER_PIECE = 24 };

status tube_curve_cut(const tube_curve *c, double from, double to, double radius, tube_curve *out)
{
    status st = OK;
    vec3 *p = NULL;
    double *s = NULL;
    tube_curve cut = {0};
    const int fine = (int)fmax(1, fmin(TUBE_MOST_PIECES, ceil((to - from) / radius)));
    const int n = CUT_PER_PIECE * fine;
    TRY(TAKE(p, (size_t)n + 1));
    TRY(TAKE(s, (size_t)n + 1));
    for (int i = 0; i <= n; i++) {
        const double du = (to - from) / n, u = from + i * du;
        vec3 d1, before, half;
        p[i] = tube_curve_at(c, u, &d1, NULL);
        (void)tube_curve_at(c, u - du / 2, &half, NULL);
        (void)tube_curve_at(c, u - du, &before, NULL);
        s[i] =
            i ? s[i - 1] + du / 6 * (vec3_norm(before) + 4 * vec3_norm(half) + vec3_norm(d1)) : 0;
    }
    TRY(tube_curve_make(c->door, fine, s[n], &cut));
    TRY(tube_curve_through(&cut, n + 1, s, p, 0.02 * radius));
    *out = cut;
    cut = (tube_curve){0};

done:
    free(p);
    free(s);
    tube_curve_free(&cut);
    return st;
}
