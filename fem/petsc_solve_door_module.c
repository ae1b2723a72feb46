// fem/petsc_solve_door_module.c
// Solutions by the factors, and residuals in extended precision, each rank with its own rows.
#include "fem/petsc_inside.h"

#include "base/memory.h"

#include <string.h>

// --- A x

typedef struct product {
    size_t ncol, rows, above;
    double *x;      // [rows + above][ncol]
    long double *y; // the same
} product;

// this rank's rows of the upper triangle and their mirror
static status multiply_rows(petsc_matrix *m, product *p)
{
    status st = OK;
    const PetscInt begin = PETSC_BLOCK * m->first, end = PETSC_BLOCK * m->last;
    for (PetscInt row = begin; row < end; row++) {
        PetscInt count = 0;
        const PetscInt *column = NULL;
        const PetscScalar *a = NULL;
        PETSC_TRY(MatGetRow(m->A, row, &count, &column, &a));
        const size_t i = (size_t)(row - begin) * p->ncol;
        for (PetscInt k = 0; k < count; k++) {
            if (column[k] < row) {
                continue;
            }
            const size_t j = (size_t)(column[k] - begin) * p->ncol;
            for (size_t c = 0; c < p->ncol; c++) {
                p->y[i + c] += (long double)a[k] * p->x[j + c];
                p->y[j + c] += i == j ? 0 : (long double)a[k] * p->x[i + c];
            }
        }
        PETSC_TRY(MatRestoreRow(m->A, row, &count, &column, &a));
    }

done:
    return st;
}

// what the next rank has of x comes to this one
static void get_above(const petsc_matrix *m, product *p)
{
    const int send = PETSC_BLOCK * m->nfirst * (int)p->ncol;
    const int get = PETSC_BLOCK * m->nabove * (int)p->ncol;
    (void)MPI_Sendrecv(p->x, send, MPI_DOUBLE, m->before, 0, p->x + p->rows * p->ncol, get,
                       MPI_DOUBLE, m->after, 0, PETSC_COMM_WORLD, MPI_STATUS_IGNORE);
}

// what this one has of y for the next rank's rows goes there
static status add_below(const petsc_matrix *m, product *p)
{
    status st = OK;
    long double *got = NULL;
    const size_t count = (size_t)PETSC_BLOCK * (size_t)m->nfirst * p->ncol;
    const int send = PETSC_BLOCK * m->nabove * (int)p->ncol;
    TRY(TAKE(got, count));
    (void)MPI_Sendrecv(p->y + p->rows * p->ncol, send, MPI_LONG_DOUBLE, m->after, 0, got,
                       (int)count, MPI_LONG_DOUBLE, m->before, 0, PETSC_COMM_WORLD,
                       MPI_STATUS_IGNORE);
    for (size_t i = 0; i < count; i++) {
        p->y[i] += got[i];
    }

done:
    free(got);
    return st;
}

status petsc_matrix_multiply(petsc_matrix *m, int ncol, const double *x, long double *y)
{
    status st = OK;
    product p = {.ncol = (size_t)ncol,
                 .rows = PETSC_BLOCK * (size_t)(m->last - m->first),
                 .above = PETSC_BLOCK * (size_t)m->nabove};
    const size_t own = p.rows * p.ncol, all = own + p.above * p.ncol;
    TRY(TAKE(p.x, all));
    TRY(TAKE(p.y, all));
    memcpy(p.x, x, own * sizeof *x);
    get_above(m, &p);
    TRY(multiply_rows(m, &p));
    TRY(add_below(m, &p));
    memcpy(y, p.y, own * sizeof *y);

done:
    free(p.x);
    free(p.y);
    return st;
}

// --- A^-1 b

static status dense_make(const petsc_matrix *m, int ncol, Mat *out)
{
    status st = OK;
    const PetscInt n = PETSC_BLOCK * (m->last - m->first);
    PETSC_TRY(MatCreateDense(PETSC_COMM_WORLD, n, PETSC_DECIDE, PETSC_BLOCK * m->nblock, ncol, NULL,
                             out));

done:
    return st;
}

status petsc_matrix_solve(petsc_matrix *m, int ncol, const double *b, double *x)
{
    status st = OK;
    Mat B = NULL, X = NULL;
    PetscScalar *to = NULL;
    const PetscScalar *from = NULL;
    const size_t all = PETSC_BLOCK * (size_t)(m->last - m->first) * (size_t)ncol;
    TRY(dense_make(m, ncol, &B));
    TRY(dense_make(m, ncol, &X));
    PETSC_TRY(MatDenseGetArrayWrite(B, &to));
    memcpy(to, b, all * sizeof *to);
    PETSC_TRY(MatDenseRestoreArrayWrite(B, &to));
    PETSC_TRY(MatMatSolve(m->factor, B, X));
    PETSC_TRY(MatDenseGetArrayRead(X, &from));
    memcpy(x, from, all * sizeof *x);
    PETSC_TRY(MatDenseRestoreArrayRead(X, &from));

done:
    (void)MatDestroy(&B);
    (void)MatDestroy(&X);
    return st;
}
