// fem/refined_solve.c
#include "fem/refined_solve.h"

#include "base/memory.h"

#include <math.h>
#include <string.h>

// a backward stable factorization leaves a few times the rounding of a row's sum
static const double RESIDUAL_LIMIT = 1e-12;

// What a step may change of x: the condition of the matrix times the rounding. Beyond, the next
// steps would not converge: the matrix is singular to rounding.
static const double CHANGE_LIMIT = 1e-2;

// Error that is left, estimated by the steps' own contraction, over x: a few digits of rounding.
static const double ENOUGH = 1e-14;

enum { MAX_STEPS = 5 };

typedef struct refinement {
    const petsc_door *door;
    petsc_matrix *matrix;
    double norm;
    size_t n, ncol;
    const double *b;
    double *x, *r, *d; // [ncol][n]
    double *by_rows;   // [n][ncol]
    long double *y;    // [n][ncol]
    double *most;      // [ncol] room for maxima
} refinement;

// r = b - A x, summed in extended precision: refinement then reaches the solution of this matrix to
// the last digits, on any number of ranks, where double would leave the condition number times the
// rounding
static status residual(const refinement *f)
{
    status st = OK;
    for (size_t c = 0; c < f->ncol; c++) {
        for (size_t i = 0; i < f->n; i++) {
            f->by_rows[i * f->ncol + c] = f->x[c * f->n + i];
        }
    }
    TRY(f->door->matrix_multiply(f->matrix, (int)f->ncol, f->by_rows, f->y));
    for (size_t c = 0; c < f->ncol; c++) {
        for (size_t i = 0; i < f->n; i++) {
            f->r[c * f->n + i] = (double)(f->b[c * f->n + i] - f->y[i * f->ncol + c]);
        }
    }

done:
    return st;
}

// per column, over all ranks
static void largest(const refinement *f, const double *v, double *most)
{
    for (size_t c = 0; c < f->ncol; c++) {
        most[c] = 0;
        for (size_t i = 0; i < f->n; i++) {
            // a NaN must not look small
            most[c] = fabs(v[c * f->n + i]) <= most[c] ? most[c] : fabs(v[c * f->n + i]);
        }
        most[c] = most[c] >= 0 ? most[c] : INFINITY;
    }
    f->door->largest((int)f->ncol, most);
}

static status check(const refinement *f, double *worst)
{
    double *r = f->most, *x = r + f->ncol, *b = x + f->ncol;
    largest(f, f->r, r);
    largest(f, f->x, x);
    largest(f, f->b, b);
    *worst = 0;
    for (size_t c = 0; c < f->ncol; c++) {
        const double scale = f->norm * x[c] + b[c], relative = scale == 0 ? 0 : r[c] / scale;
        if (!(relative <= RESIDUAL_LIMIT)) {
            return status_fail(ERR_NUMERIC, "MUMPS: relative residual %.2g of right-hand side %d",
                               relative, (int)c);
        }
        *worst = fmax(*worst, relative);
    }
    return OK;
}

// largest change of x by d over x, of all columns
static double change(const refinement *f)
{
    double *d = f->most, *x = d + f->ncol, most = 0;
    largest(f, f->d, d);
    largest(f, f->x, x);
    for (size_t c = 0; c < f->ncol; c++) {
        most = fmax(most, x[c] == 0 ? 0 : d[c] / x[c]);
    }
    return most;
}

static status refine(const refinement *f)
{
    status st = OK;
    double rate = 0;
    for (int step = 0; step < MAX_STEPS; step++) {
        TRY(f->door->matrix_solve(f->matrix, (int)f->ncol, f->r, f->d));
        const double moved = change(f);
        if (step == 0) {
            rate = moved;
        }
        if (!(rate <= CHANGE_LIMIT)) {
            TRY(status_fail(ERR_NUMERIC,
                            "segment: the supports or the joints between its parts leave the body "
                            "free to move (solutions uncertain by %.1g)",
                            rate));
        }
        for (size_t i = 0; i < f->n * f->ncol; i++) {
            f->x[i] += f->d[i];
        }
        if (rate * moved <= ENOUGH) {
            break;
        }
        TRY(residual(f));
    }

done:
    return st;
}

status refined_solve(const petsc_door *door, petsc_matrix *matrix, double norm, size_t n, int ncol,
                     const double *b, double *x, double *relative)
{
    status st = OK;
    refinement f = {
        .door = door, .matrix = matrix, .norm = norm, .n = n, .ncol = (size_t)ncol, .b = b, .x = x};
    const size_t all = n * (size_t)ncol;
    st = TAKE(f.r, all);
    st = st ? st : TAKE(f.d, all);
    st = st ? st : TAKE(f.by_rows, all);
    st = st ? st : TAKE(f.y, all);
    st = st ? st : TAKE(f.most, 3 * (size_t)ncol);
    TRY(door->agree(st));
    TRY(door->matrix_solve(matrix, ncol, b, x));
    TRY(residual(&f));
    TRY(check(&f, relative));
    TRY(refine(&f));

done:
    free(f.r);
    free(f.d);
    free(f.by_rows);
    free(f.y);
    free(f.most);
    return st;
}
