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
    const refined_system *s;
    double *x, *r, *d; // [ncol][n]
    double *most;      // [3][ncol] room for maxima
} refinement;

// per column, over all ranks
static void largest(const refinement *f, const double *v, double *most)
{
    const size_t n = f->s->n;
    for (size_t c = 0; c < (size_t)f->s->ncol; c++) {
        most[c] = 0;
        for (size_t i = 0; i < n; i++) {
            // a NaN must not look small
            most[c] = fabs(v[c * n + i]) <= most[c] ? most[c] : fabs(v[c * n + i]);
        }
        most[c] = most[c] >= 0 ? most[c] : INFINITY;
    }
    f->s->door->largest(f->s->ncol, most);
}

static status check(const refinement *f, double *worst)
{
    double *r = f->most, *x = r + f->s->ncol, *b = x + f->s->ncol;
    largest(f, f->r, r);
    largest(f, f->x, x);
    largest(f, f->s->b, b);
    *worst = 0;
    for (int c = 0; c < f->s->ncol; c++) {
        const double scale = f->s->norm * x[c] + b[c], relative = scale == 0 ? 0 : r[c] / scale;
        if (!(relative <= RESIDUAL_LIMIT)) {
            return status_fail(ERR_NUMERIC, "MUMPS: relative residual %.2g of right-hand side %d",
                               relative, c);
        }
        *worst = fmax(*worst, relative);
    }
    return OK;
}

// largest change of x by d over x, of all columns
static double change(const refinement *f)
{
    double *d = f->most, *x = d + f->s->ncol, most = 0;
    largest(f, f->d, d);
    largest(f, f->x, x);
    for (int c = 0; c < f->s->ncol; c++) {
        most = fmax(most, x[c] == 0 ? 0 : d[c] / x[c]);
    }
    return most;
}

static status refine(const refinement *f, double *moved)
{
    status st = OK;
    double rate = 0;
    for (int step = 0; step < MAX_STEPS; step++) {
        TRY(f->s->door->matrix_solve(f->s->matrix, f->s->ncol, f->r, f->d));
        *moved = change(f);
        rate = step == 0 ? *moved : rate;
        if (!(rate <= CHANGE_LIMIT)) {
            TRY(status_fail(
                ERR_NUMERIC,
                "segment: singular to rounding (solutions uncertain by %.1g): supports or "
                "joints leave parts free to move, or stiffnesses lie too far apart",
                rate));
        }
        for (size_t i = 0; i < f->s->n * (size_t)f->s->ncol; i++) {
            f->x[i] += f->d[i];
        }
        if (rate * *moved <= ENOUGH) {
            break;
        }
        TRY(f->s->residual(f->s->self, f->x, f->r));
    }

done:
    return st;
}

status refined_solve(const refined_system *s, double *x, refined_answer *out)
{
    status st = OK;
    refinement f = {.s = s, .x = x};
    const size_t all = s->n * (size_t)s->ncol;
    st = TAKE(f.r, all);
    st = st ? st : TAKE(f.d, all);
    st = st ? st : TAKE(f.most, 3 * (size_t)s->ncol);
    TRY(s->door->agree(st));
    TRY(s->door->matrix_solve(s->matrix, s->ncol, s->b, x));
    TRY(s->residual(s->self, x, f.r));
    TRY(check(&f, &out->residual));
    TRY(refine(&f, &out->moved));

done:
    free(f.r);
    free(f.d);
    free(f.most);
    return st;
}
