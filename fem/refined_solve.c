// fem/refined_solve.c
#include "fem/refined_solve.h"

#include "base/memory.h"

#include <math.h>
#include <string.h>

// a backward stable factorization leaves a few times the rounding of a row's sum
static const double RESIDUAL_LIMIT = 1e-12;

// r = b - A x, summed in extended precision: refinement then reaches the solution of this matrix to
// the last digits, on any number of ranks, where double would leave the condition number times the
// rounding
static status residual(const petsc_door *door, petsc_matrix *matrix, size_t n, int ncol,
                       const double *b, const double *x, double *r)
{
    status st = OK;
    const size_t many = (size_t)ncol;
    double *by_rows = NULL;
    long double *y = NULL;
    TRY(TAKE(by_rows, n * many));
    TRY(TAKE(y, n * many));
    for (size_t c = 0; c < many; c++) {
        for (size_t i = 0; i < n; i++) {
            by_rows[i * many + c] = x[c * n + i];
        }
    }
    TRY(door->matrix_multiply(matrix, ncol, by_rows, y));
    for (size_t c = 0; c < many; c++) {
        for (size_t i = 0; i < n; i++) {
            r[c * n + i] = (double)(b[c * n + i] - y[i * many + c]);
        }
    }

done:
    free(by_rows);
    free(y);
    return st;
}

static double largest(size_t n, const double *v)
{
    double most = 0;
    for (size_t i = 0; i < n; i++) {
        // a NaN must not look small
        most = fabs(v[i]) <= most ? most : fabs(v[i]);
    }
    return most;
}

static status check(double norm, size_t n, int ncol, const double *b, const double *x,
                    const double *r, double *worst)
{
    *worst = 0;
    for (size_t c = 0; c < (size_t)ncol; c++) {
        const double scale = norm * largest(n, x + c * n) + largest(n, b + c * n);
        const double relative = scale == 0 ? 0 : largest(n, r + c * n) / scale;
        if (!(relative <= RESIDUAL_LIMIT)) {
            return status_fail(ERR_NUMERIC, "MUMPS: relative residual %.2g of right-hand side %d",
                               relative, (int)c);
        }
        *worst = fmax(*worst, relative);
    }
    return OK;
}

status refined_solve(const petsc_door *door, petsc_matrix *matrix, double norm, size_t n, int ncol,
                     const double *b, double *x, double *relative)
{
    status st = OK;
    double *r = NULL, *d = NULL;
    const size_t all = n * (size_t)ncol;
    TRY(TAKE(r, all));
    TRY(TAKE(d, all));
    TRY(door->matrix_solve(matrix, ncol, b, x));
    TRY(residual(door, matrix, n, ncol, b, x, r));
    TRY(check(norm, n, ncol, b, x, r, relative));
    TRY(door->matrix_solve(matrix, ncol, r, d));
    for (size_t i = 0; i < all; i++) {
        x[i] += d[i];
    }

done:
    free(r);
    free(d);
    return st;
}
