// fem/petsc_solve_door_module.c
// Solutions by the factors, each rank with its own rows.
#include "fem/petsc_inside.h"

#include <string.h>

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
    if (m->grid) {
        return petsc_grid_solve(m, ncol, b, x);
    }
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
