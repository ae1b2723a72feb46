// fem/petsc_matrix_door_module.c
// The stiffness matrix by rows of ranks, and its factors by MUMPS.
#include "fem/petsc_inside.h"

#include "base/memory.h"

#include <limits.h>
#include <stdbool.h>
#include <string.h>

// the matrix is held by PETSc, and as rows and columns by MUMPS
enum { COPIES = 2 };

// unknowns from which on nested dissection pays
enum { DISSECTED = 100000 };

// MUMPS' own numbering of its answers
enum {
    INFOG_STATE = 1,
    INFOG_DETAIL = 2,
    INFOG_MEGABYTES = 17,
    INFOG_ENTRIES = 29,
    INFO_MEGABYTES = 22,
    RINFOG_FLOPS = 3
};

void petsc_matrix_free(petsc_matrix *m)
{
    if (!m) {
        return;
    }
    petsc_grid_free(m->grid);
    (void)MatDestroy(&m->factor);
    (void)MatDestroy(&m->A);
    free(m);
}

// PETSc and MUMPS count a rank's entries with int, and a kernel that has no memory left kills
// instead of refusing
static status check_entries(const petsc_pattern *p)
{
    double blocks = 0;
    for (int i = 0; i < p->last - p->first; i++) {
        blocks += (double)p->diagonal[i] + p->beyond[i];
    }
    const double entries = PETSC_BLOCK * PETSC_BLOCK * blocks;
    const double bytes = COPIES * entries * (sizeof(PetscScalar) + sizeof(PetscInt));
    if (entries > INT_MAX || PETSC_BLOCK * (double)p->nblock > INT_MAX ||
        bytes > petsc_machine_memory()) {
        return status_fail(ERR_RESOURCE,
                           "segment: a matrix of %.3g million entries for %.3g million unknowns is "
                           "too large: " PETSC_SMALLER,
                           entries * 1e-6, PETSC_BLOCK * 1e-6 * p->nblock);
    }
    return OK;
}

status petsc_matrix_make(const petsc_pattern *p, petsc_matrix **out)
{
    status st = OK;
    petsc_matrix *m = NULL;
    const PetscInt n = PETSC_BLOCK * (p->last - p->first);

    TRY(petsc_agree(check_entries(p)));
    TRY(petsc_agree(TAKE(m, 1)));
    *m = (petsc_matrix){.nblock = p->nblock, .first = p->first, .last = p->last};
    PETSC_TRY(MatCreate(PETSC_COMM_WORLD, &m->A));
    PETSC_TRY(MatSetSizes(m->A, n, n, PETSC_BLOCK * p->nblock, PETSC_BLOCK * p->nblock));
    PETSC_TRY(MatSetType(m->A, MATSBAIJ));
    PETSC_TRY(MatSetBlockSize(m->A, PETSC_BLOCK));
    PETSC_TRY(MatSeqSBAIJSetPreallocation(m->A, PETSC_BLOCK, 0, p->diagonal));
    PETSC_TRY(MatMPISBAIJSetPreallocation(m->A, PETSC_BLOCK, 0, p->diagonal, 0, p->beyond));
    PETSC_TRY(MatSetOption(m->A, MAT_IGNORE_LOWER_TRIANGULAR, PETSC_TRUE));
    PETSC_TRY(MatSetOption(m->A, MAT_IGNORE_OFF_PROC_ENTRIES, PETSC_TRUE));
    PETSC_TRY(MatSetOption(m->A, MAT_GETROW_UPPERTRIANGULAR, PETSC_TRUE));
    PETSC_TRY(MatSetOption(m->A, MAT_SPD, PETSC_TRUE));
    *out = m;
    m = NULL;

done:
    petsc_matrix_free(m);
    return st;
}

status petsc_matrix_add(petsc_matrix *m, int n, const int *block, const double *a)
{
    status st = OK;
    PETSC_TRY(MatSetValuesBlocked(m->A, n, block, n, block, a, ADD_VALUES));

done:
    return st;
}

// --- factor

// MUMPS' codes for: work arrays too small (-8, -9, -11, -14, -15), no memory (-5, -7, -13, -19,
// -22), buffers too small (-17, -18, -20), counts beyond int (-51, -52)
static bool is_out_of_memory(PetscInt state)
{
    static const int codes[] = {-5,  -7,  -8,  -9,  -11, -13, -14, -15,
                                -17, -18, -19, -20, -22, -51, -52};
    for (size_t i = 0; i < sizeof codes / sizeof *codes; i++) {
        if (state == codes[i]) {
            return true;
        }
    }
    return false;
}

static status factor_check(Mat factor)
{
    status st = OK;
    PetscInt state = 0, detail = 0;
    MatFactorError error = MAT_FACTOR_NOERROR;
    PETSC_TRY(MatMumpsGetInfog(factor, INFOG_STATE, &state));
    PETSC_TRY(MatMumpsGetInfog(factor, INFOG_DETAIL, &detail));
    PETSC_TRY(MatFactorGetError(factor, &error));
    if (state == 0 && error == MAT_FACTOR_NOERROR) {
        return OK;
    }
    if (state == -10 || error == MAT_FACTOR_NUMERIC_ZEROPIVOT) {
        return status_fail(ERR_NUMERIC, "MUMPS: the stiffness matrix is not positive definite: "
                                        "parts of the body are not joined, or free to move");
    }
    if (is_out_of_memory(state) || error == MAT_FACTOR_OUTMEMORY) {
        return status_fail(ERR_RESOURCE,
                           "MUMPS: not enough memory for the factors, code %d, %d: " PETSC_SMALLER,
                           (int)state, (int)detail);
    }
    return status_fail(ERR_NUMERIC, "MUMPS: factorization failed, code %d, %d", (int)state,
                       (int)detail);

done:
    return st;
}

// what the analysis says that the factors will take, all ranks together
static status check_memory(Mat factor)
{
    status st = OK;
    PetscInt megabytes = 0;
    PETSC_TRY(MatMumpsGetInfog(factor, INFOG_MEGABYTES, &megabytes));
    if (1e6 * megabytes > petsc_machine_memory()) {
        TRY(status_fail(ERR_RESOURCE,
                        "MUMPS: the factors would take %.3g GB, more than there is: " PETSC_SMALLER,
                        1e-3 * megabytes));
    }

done:
    return st;
}

static status tell(const petsc_matrix *m, petsc_factors *out)
{
    status st = OK;
    MatInfo info;
    PetscInt entries = 0, megabytes = 0;
    PETSC_TRY(MatMumpsGetInfog(m->factor, INFOG_ENTRIES, &entries));
    PETSC_TRY(MatMumpsGetInfo(m->factor, INFO_MEGABYTES, &megabytes));
    PETSC_TRY(MatMumpsGetRinfog(m->factor, RINFOG_FLOPS, &out->flops));
    PETSC_TRY(MatGetInfo(m->A, MAT_LOCAL, &info));
    out->entries = entries < 0 ? -1e6 * entries : entries; // millions where they are many
    out->bytes = info.memory + 1e6 * megabytes;

done:
    return st;
}

// Approximate minimum fill is the faster of Debian's orderings to begin with; nested dissection
// (SCOTCH) leaves half the operations at 2.3e5 unknowns
static const char *ordering(const petsc_matrix *m)
{
    return PETSC_BLOCK * m->nblock < DISSECTED ? "2" : "3";
}

status petsc_matrix_factor(petsc_matrix *m, petsc_factors *out)
{
    status st = OK;
    MatFactorInfo info;
    PETSC_TRY(PetscOptionsSetValue(NULL, "-mat_mumps_icntl_7", ordering(m)));
    PETSC_TRY(MatAssemblyBegin(m->A, MAT_FINAL_ASSEMBLY));
    PETSC_TRY(MatAssemblyEnd(m->A, MAT_FINAL_ASSEMBLY));
    PETSC_TRY(MatNorm(m->A, NORM_INFINITY, &out->norm));
    PETSC_TRY(MatGetFactor(m->A, MATSOLVERMUMPS, MAT_FACTOR_CHOLESKY, &m->factor));
    PETSC_TRY(MatFactorInfoInitialize(&info));
    PETSC_TRY(MatCholeskyFactorSymbolic(m->factor, m->A, NULL, &info));
    TRY(factor_check(m->factor));
    TRY(check_memory(m->factor));
    PETSC_TRY(MatCholeskyFactorNumeric(m->factor, m->A, &info));
    TRY(factor_check(m->factor));
    TRY(tell(m, out));

done:
    return st;
}
