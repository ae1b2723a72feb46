// fem/petsc_plane_door_module.c
// Sparse factors of one rank alone, and what all ranks exchange.
#include "fem/petsc_inside.h"

#include "base/memory.h"
#include "fem/petsc_plane_door.h"

#include <limits.h>

struct petsc_plane {
    Mat factor;
    int n;
    double bytes;
};

static void plane_free(petsc_plane *p)
{
    if (p) {
        (void)MatDestroy(&p->factor);
        free(p);
    }
}

static status check(Mat factor)
{
    status st = OK;
    MatFactorError error = MAT_FACTOR_NOERROR;
    PETSC_TRY(MatFactorGetError(factor, &error));
    if (error == MAT_FACTOR_OUTMEMORY) {
        TRY(status_fail(ERR_RESOURCE, "CHOLMOD: no memory for the factors: " PETSC_SMALLER));
    }
    if (error != MAT_FACTOR_NOERROR) {
        TRY(status_fail(ERR_NUMERIC, "CHOLMOD: a plane's matrix is not positive definite"));
    }

done:
    return st;
}

static status plane_factor(int n, const int *start, const int *column, const double *value,
                           petsc_plane **out)
{
    status st = OK;
    Mat A = NULL;
    petsc_plane *p = NULL;
    MatFactorInfo info;
    TRY(TAKE(p, 1));
    *p = (petsc_plane){.n = n};
    // PETSc reads the arrays only, though it does not say so
    PETSC_TRY(MatCreateSeqSBAIJWithArrays(PETSC_COMM_SELF, 1, n, n, (PetscInt *)start,
                                          (PetscInt *)column, (PetscScalar *)value, &A));
    PETSC_TRY(MatSetOption(A, MAT_SPD, PETSC_TRUE));
    PETSC_TRY(MatGetFactor(A, MATSOLVERCHOLMOD, MAT_FACTOR_CHOLESKY, &p->factor));
    PETSC_TRY(MatFactorInfoInitialize(&info));
    PETSC_TRY(MatCholeskyFactorSymbolic(p->factor, A, NULL, &info));
    PETSC_TRY(MatCholeskyFactorNumeric(p->factor, A, &info));
    TRY(check(p->factor));
    MatInfo found;
    PETSC_TRY(MatGetInfo(p->factor, MAT_LOCAL, &found));
    p->bytes = found.memory;
    *out = p;
    p = NULL;

done:
    (void)MatDestroy(&A);
    plane_free(p);
    return st;
}

static status plane_solve(petsc_plane *p, int ncol, const double *b, double *x)
{
    status st = OK;
    Mat B = NULL, X = NULL;
    PETSC_TRY(MatCreateSeqDense(PETSC_COMM_SELF, p->n, ncol, (PetscScalar *)b, &B));
    PETSC_TRY(MatCreateSeqDense(PETSC_COMM_SELF, p->n, ncol, x, &X));
    PETSC_TRY(MatMatSolve(p->factor, B, X));

done:
    (void)MatDestroy(&B);
    (void)MatDestroy(&X);
    return st;
}

static double plane_bytes(const petsc_plane *p)
{
    return p->bytes;
}

// counts and where they begin, [2 size]; MPI counts with int
static status places(int size, const int *count, int *at)
{
    long long next = 0;
    for (int i = 0; i < size; i++) {
        at[i] = (int)next;
        next += count[i];
        if (next > INT_MAX) {
            return status_fail(ERR_RESOURCE, "segment: more values for one rank than MPI counts: "
                                             "take more ranks, or " PETSC_SMALLER);
        }
    }
    return OK;
}

static status exchange(const int *nsend, const double *send, const int *nget, double *get)
{
    status st = OK;
    int size = 1, *at = NULL;
    (void)MPI_Comm_size(PETSC_COMM_WORLD, &size);
    st = TAKE(at, 2 * (size_t)size);
    st = st ? st : places(size, nsend, at);
    st = st ? st : places(size, nget, at + size);
    TRY(petsc_agree(st));
    (void)MPI_Alltoallv(send, nsend, at, MPI_DOUBLE, get, nget, at + size, MPI_DOUBLE,
                        PETSC_COMM_WORLD);

done:
    free(at);
    return st;
}

const petsc_plane_door *stiffaxis_petsc_plane_door(void);

const petsc_plane_door *stiffaxis_petsc_plane_door(void)
{
    static const petsc_plane_door door = {.factor = plane_factor,
                                          .solve = plane_solve,
                                          .bytes = plane_bytes,
                                          .free = plane_free,
                                          .exchange = exchange};
    return &door;
}
