// fem/petsc_door_module.c
#include "fem/petsc_door.h"

#include "base/memory.h"

#include <limits.h>
#include <petscmat.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <unistd.h>

// what MPI keeps until the process ends is no leak of ours
#ifdef __SANITIZE_ADDRESS__
#include <sanitizer/lsan_interface.h>
#else
#define __lsan_disable() ((void)0)
#define __lsan_enable() ((void)0)
#endif

enum { BLOCK = 3 };

// the matrix is held by PETSc, and as rows and columns by MUMPS
enum { COPIES = 2 };

// MUMPS' own numbering of its answers
enum { INFOG_STATE = 1, INFOG_DETAIL = 2, INFOG_MEGABYTES = 17 };

// Set before the library starts, since PETSc 3.18 forgets MUMPS controls that are set on the
// factor. Ordering 2 (approximate minimum fill) was the fastest of Debian's on columns of 10 k to
// 140 k unknowns; the graph is compressed by blocks.
static const struct {
    const char *name, *value;
} settings[] = {
    {"-skip_petscrc", "1"},        {"-no_signal_handler", "1"},   {"-mat_mumps_icntl_7", "2"},
    {"-mat_mumps_icntl_15", "-3"}, {"-mat_mumps_icntl_14", "40"},
};

struct petsc_matrix {
    Mat A, factor;
    int nblock, first, last;
    int *rows;  // [size] values that each rank holds
    int *start; // [size] where they begin
    int size;
};

// what a user can do about memory
#define SMALLER "take fewer fem.layers, a lower fem.order or a larger fem.size_mm"

static status petsc_fail(PetscErrorCode code, const char *call)
{
    const char *words = NULL;
    // an allocation that fails below some layers of PETSc comes up as one of these
    if (code == PETSC_ERR_MEM) {
        return status_fail(ERR_RESOURCE, "PETSc: out of memory in %s: " SMALLER, call);
    }
    (void)PetscErrorMessage(code, &words, NULL);
    return status_fail(ERR_BUG, "PETSc: %s (code %d), in %s", words ? words : "no message",
                       (int)code, call);
}

#define PETSC_TRY(call)                                                                            \
    do {                                                                                           \
        PetscErrorCode code_ = (call);                                                             \
        if (code_) {                                                                               \
            TRY(petsc_fail(code_, #call));                                                         \
        }                                                                                          \
    } while (0)

// --- start and end

static void finish(void)
{
    PetscBool finished = PETSC_TRUE;
    (void)PetscFinalized(&finished);
    if (!finished) {
        (void)PetscFinalize();
    }
}

// no option may come from outside the case; a process of its own needs no daemon and no network
static void prepare_environment(void)
{
    (void)unsetenv("PETSC_OPTIONS");
    (void)unsetenv("PETSC_OPTIONS_YAML");
    if (!getenv("OMPI_COMM_WORLD_SIZE")) {
        (void)setenv("OMPI_MCA_ess_singleton_isolated", "1", 1);
        (void)setenv("OMPI_MCA_pml", "ob1", 1);
    }
}

static status start(int *rank, int *size)
{
    status st = OK;
    PetscBool ready = PETSC_FALSE;
    PETSC_TRY(PetscInitialized(&ready));
    if (!ready) {
        prepare_environment();
        for (size_t i = 0; i < sizeof settings / sizeof *settings; i++) {
            PETSC_TRY(PetscOptionsSetValue(NULL, settings[i].name, settings[i].value));
        }
        __lsan_disable();
        const PetscErrorCode begun = PetscInitializeNoArguments();
        __lsan_enable();
        PETSC_TRY(begun);
        (void)atexit(finish);
        // errors come back as codes: no trace on the user's screen
        PETSC_TRY(PetscPushErrorHandler(PetscIgnoreErrorHandler, NULL));
    }
    (void)MPI_Comm_rank(PETSC_COMM_WORLD, rank);
    (void)MPI_Comm_size(PETSC_COMM_WORLD, size);

done:
    return st;
}

// --- the matrix

static void matrix_free(petsc_matrix *m)
{
    if (!m) {
        return;
    }
    (void)MatDestroy(&m->factor);
    (void)MatDestroy(&m->A);
    free(m->rows);
    free(m->start);
    free(m);
}

// how the values of a vector lie on the ranks
static status share_rows(petsc_matrix *m)
{
    status st = OK;
    (void)MPI_Comm_size(PETSC_COMM_WORLD, &m->size);
    TRY(TAKE(m->rows, (size_t)m->size));
    TRY(TAKE(m->start, (size_t)m->size));
    const int mine = BLOCK * (m->last - m->first), from = BLOCK * m->first;
    (void)MPI_Allgather(&mine, 1, MPI_INT, m->rows, 1, MPI_INT, PETSC_COMM_WORLD);
    (void)MPI_Allgather(&from, 1, MPI_INT, m->start, 1, MPI_INT, PETSC_COMM_WORLD);

done:
    return st;
}

// memory of the machine, or of what the process may have of it [byte]
static double machine_memory(void)
{
    double limit = (double)sysconf(_SC_PHYS_PAGES) * (double)sysconf(_SC_PAGESIZE), group = 0;
    struct rlimit room;
    if (getrlimit(RLIMIT_AS, &room) == 0 && room.rlim_cur != RLIM_INFINITY) {
        limit = (double)room.rlim_cur < limit ? (double)room.rlim_cur : limit;
    }
    FILE *file = fopen("/sys/fs/cgroup/memory.max", "r");
    if (file) {
        // "max" where there is no limit
        limit = fscanf(file, "%lf", &group) == 1 && group < limit ? group : limit;
        (void)fclose(file);
    }
    return limit;
}

// PETSc and MUMPS count a rank's entries with int, and a kernel that has no memory left kills
// instead of refusing
static status check_entries(const petsc_pattern *p)
{
    double blocks = 0;
    for (int i = 0; i < p->last - p->first; i++) {
        blocks += (double)p->diagonal[i] + p->beyond[i];
    }
    const double entries = BLOCK * BLOCK * blocks;
    const double bytes = COPIES * entries * (sizeof(PetscScalar) + sizeof(PetscInt));
    if (entries > INT_MAX || BLOCK * (double)p->nblock > INT_MAX || bytes > machine_memory()) {
        return status_fail(ERR_RESOURCE,
                           "segment: a matrix of %.3g million entries for %.3g million unknowns is "
                           "too large: " SMALLER,
                           entries * 1e-6, BLOCK * 1e-6 * p->nblock);
    }
    return OK;
}

static status matrix_make(const petsc_pattern *p, petsc_matrix **out)
{
    status st = OK;
    petsc_matrix *m = NULL;
    const PetscInt n = BLOCK * (p->last - p->first);

    TRY(check_entries(p));
    TRY(TAKE(m, 1));
    *m = (petsc_matrix){.nblock = p->nblock, .first = p->first, .last = p->last};
    TRY(share_rows(m));
    PETSC_TRY(MatCreate(PETSC_COMM_WORLD, &m->A));
    PETSC_TRY(MatSetSizes(m->A, n, n, BLOCK * p->nblock, BLOCK * p->nblock));
    PETSC_TRY(MatSetType(m->A, MATSBAIJ));
    PETSC_TRY(MatSetBlockSize(m->A, BLOCK));
    PETSC_TRY(MatSeqSBAIJSetPreallocation(m->A, BLOCK, 0, p->diagonal));
    PETSC_TRY(MatMPISBAIJSetPreallocation(m->A, BLOCK, 0, p->diagonal, 0, p->beyond));
    PETSC_TRY(MatSetOption(m->A, MAT_IGNORE_LOWER_TRIANGULAR, PETSC_TRUE));
    PETSC_TRY(MatSetOption(m->A, MAT_IGNORE_OFF_PROC_ENTRIES, PETSC_TRUE));
    PETSC_TRY(MatSetOption(m->A, MAT_GETROW_UPPERTRIANGULAR, PETSC_TRUE));
    PETSC_TRY(MatSetOption(m->A, MAT_SPD, PETSC_TRUE));
    *out = m;
    m = NULL;

done:
    matrix_free(m);
    return st;
}

static status matrix_add(petsc_matrix *m, int n, const int *block, const double *a)
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
        return status_fail(ERR_NUMERIC, "MUMPS: the stiffness matrix is not positive definite");
    }
    if (is_out_of_memory(state) || error == MAT_FACTOR_OUTMEMORY) {
        return status_fail(ERR_RESOURCE,
                           "MUMPS: not enough memory for the factors, code %d, %d: " SMALLER,
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
    if (1e6 * megabytes > machine_memory()) {
        TRY(status_fail(ERR_RESOURCE,
                        "MUMPS: the factors would take %.3g GB, more than there is: " SMALLER,
                        1e-3 * megabytes));
    }

done:
    return st;
}

static status matrix_factor(petsc_matrix *m, double *norm)
{
    status st = OK;
    MatFactorInfo info;
    PETSC_TRY(MatAssemblyBegin(m->A, MAT_FINAL_ASSEMBLY));
    PETSC_TRY(MatAssemblyEnd(m->A, MAT_FINAL_ASSEMBLY));
    PETSC_TRY(MatNorm(m->A, NORM_INFINITY, norm));
    PETSC_TRY(MatGetFactor(m->A, MATSOLVERMUMPS, MAT_FACTOR_CHOLESKY, &m->factor));
    PETSC_TRY(MatFactorInfoInitialize(&info));
    PETSC_TRY(MatCholeskyFactorSymbolic(m->factor, m->A, NULL, &info));
    TRY(factor_check(m->factor));
    TRY(check_memory(m->factor));
    PETSC_TRY(MatCholeskyFactorNumeric(m->factor, m->A, &info));
    TRY(factor_check(m->factor));

done:
    return st;
}

// --- solve

// this rank's rows of the upper triangle and their mirror
static status matrix_multiply(petsc_matrix *m, int n, const double *x, long double *y)
{
    status st = OK;
    const size_t ncol = (size_t)n, all = BLOCK * (size_t)m->nblock;
    memset(y, 0, all * ncol * sizeof *y);
    for (PetscInt row = BLOCK * m->first; row < BLOCK * m->last; row++) {
        PetscInt count = 0;
        const PetscInt *column = NULL;
        const PetscScalar *a = NULL;
        PETSC_TRY(MatGetRow(m->A, row, &count, &column, &a));
        for (PetscInt k = 0; k < count; k++) {
            const size_t i = (size_t)row * ncol, j = (size_t)column[k] * ncol;
            for (size_t c = 0; c < ncol && j >= i; c++) {
                y[i + c] += (long double)a[k] * x[j + c];
                y[j + c] += i == j ? 0 : (long double)a[k] * x[i + c];
            }
        }
        PETSC_TRY(MatRestoreRow(m->A, row, &count, &column, &a));
    }
    for (size_t c = 0; c < ncol; c++) { // by parts: MPI counts with int
        (void)MPI_Allreduce(MPI_IN_PLACE, y + c * all, (int)all, MPI_LONG_DOUBLE, MPI_SUM,
                            PETSC_COMM_WORLD);
    }

done:
    return st;
}

static status dense_make(const petsc_matrix *m, int ncol, Mat *out)
{
    status st = OK;
    const PetscInt n = BLOCK * (m->last - m->first);
    PETSC_TRY(
        MatCreateDense(PETSC_COMM_WORLD, n, PETSC_DECIDE, BLOCK * m->nblock, ncol, NULL, out));

done:
    return st;
}

static status matrix_solve(petsc_matrix *m, int ncol, const double *b, double *x)
{
    status st = OK;
    Mat B = NULL, X = NULL;
    PetscScalar *to = NULL;
    const PetscScalar *from = NULL;
    const size_t n = BLOCK * (size_t)(m->last - m->first), all = BLOCK * (size_t)m->nblock;
    TRY(dense_make(m, ncol, &B));
    TRY(dense_make(m, ncol, &X));
    PETSC_TRY(MatDenseGetArrayWrite(B, &to));
    for (size_t j = 0; j < (size_t)ncol; j++) {
        memcpy(to + j * n, b + j * all + BLOCK * (size_t)m->first, n * sizeof *to);
    }
    PETSC_TRY(MatDenseRestoreArrayWrite(B, &to));
    PETSC_TRY(MatMatSolve(m->factor, B, X));
    PETSC_TRY(MatDenseGetArrayRead(X, &from));
    for (size_t j = 0; j < (size_t)ncol; j++) {
        (void)MPI_Allgatherv(from + j * n, (int)n, MPI_DOUBLE, x + j * all, m->rows, m->start,
                             MPI_DOUBLE, PETSC_COMM_WORLD);
    }
    PETSC_TRY(MatDenseRestoreArrayRead(X, &from));

done:
    (void)MatDestroy(&B);
    (void)MatDestroy(&X);
    return st;
}

const petsc_door *stiffaxis_petsc_door(void);

const petsc_door *stiffaxis_petsc_door(void)
{
    static const petsc_door door = {.start = start,
                                    .matrix_make = matrix_make,
                                    .matrix_add = matrix_add,
                                    .matrix_factor = matrix_factor,
                                    .matrix_solve = matrix_solve,
                                    .matrix_multiply = matrix_multiply,
                                    .matrix_free = matrix_free};
    return &door;
}
