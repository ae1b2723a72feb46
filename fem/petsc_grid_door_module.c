// fem/petsc_grid_door_module.c
// Conjugate gradients with algebraic multigrid, column by column, in place of factors.
#include "fem/petsc_inside.h"

#include <petscksp.h>

enum { MOTIONS = 6, MOST_STEPS = 1000 };

// of the natural norm of the residual: what is linear in the displacements is as good as this
static const double STEP_TOLERANCE = 1e-9;

struct petsc_grid {
    KSP solver;
    Mat A; // both triangles: what aggregates need
    int steps;
};

void petsc_grid_free(petsc_grid *g)
{
    if (g) {
        (void)KSPDestroy(&g->solver);
        (void)MatDestroy(&g->A);
        (void)PetscFree(g);
    }
}

// orthonormal, without those that are no motions of this body at all
static status orthonormalize(int count, Vec *v, int *kept)
{
    status st = OK;
    static const double SAME = 1e-8;
    *kept = 0;
    for (int i = 0; i < count; i++) {
        PetscReal before = 0, after = 0;
        PETSC_TRY(VecNorm(v[i], NORM_2, &before));
        for (int pass = 0; pass < 2; pass++) {
            for (int k = 0; k < *kept; k++) {
                PetscScalar part = 0;
                PETSC_TRY(VecDot(v[i], v[k], &part));
                PETSC_TRY(VecAXPY(v[i], -part, v[k]));
            }
        }
        PETSC_TRY(VecNorm(v[i], NORM_2, &after));
        if (after > SAME * before) {
            PETSC_TRY(VecScale(v[i], 1 / after));
            PETSC_TRY(VecSwap(v[i], v[*kept]));
            (*kept)++;
        }
    }

done:
    return st;
}

// the motions that cost nothing where nothing holds: what multigrid must keep
static status take_motions(const petsc_matrix *m, Mat A, const double *motions)
{
    status st = OK;
    Vec v[MOTIONS] = {NULL};
    MatNullSpace space = NULL;
    const size_t rows = PETSC_BLOCK * (size_t)(m->last - m->first);
    int kept = 0;
    for (int k = 0; k < MOTIONS; k++) {
        PetscScalar *to = NULL;
        PETSC_TRY(MatCreateVecs(A, &v[k], NULL));
        PETSC_TRY(VecSetBlockSize(v[k], PETSC_BLOCK));
        PETSC_TRY(VecGetArrayWrite(v[k], &to));
        for (size_t i = 0; i < rows; i++) {
            to[i] = motions[(size_t)k * rows + i];
        }
        PETSC_TRY(VecRestoreArrayWrite(v[k], &to));
    }
    TRY(orthonormalize(MOTIONS, v, &kept));
    PETSC_TRY(MatNullSpaceCreate(PETSC_COMM_WORLD, PETSC_FALSE, kept, v, &space));
    PETSC_TRY(MatSetNearNullSpace(A, space));

done:
    (void)MatNullSpaceDestroy(&space);
    for (int k = 0; k < MOTIONS; k++) {
        (void)VecDestroy(&v[k]);
    }
    return st;
}

static status take_solver(petsc_grid *g)
{
    status st = OK;
    PC pc = NULL;
    PETSC_TRY(KSPCreate(PETSC_COMM_WORLD, &g->solver));
    PETSC_TRY(KSPSetOperators(g->solver, g->A, g->A));
    PETSC_TRY(KSPSetType(g->solver, KSPCG));
    PETSC_TRY(KSPSetNormType(g->solver, KSP_NORM_NATURAL));
    PETSC_TRY(KSPSetTolerances(g->solver, STEP_TOLERANCE, 0, PETSC_DEFAULT, MOST_STEPS));
    PETSC_TRY(KSPGetPC(g->solver, &pc));
    PETSC_TRY(PCSetType(pc, PCGAMG));
    PETSC_TRY(KSPSetUp(g->solver));

done:
    return st;
}

status petsc_matrix_coarsen(petsc_matrix *m, const double *motions, petsc_factors *out)
{
    status st = OK;
    petsc_grid *g = NULL;
    MatInfo info;
    PETSC_TRY(MatAssemblyBegin(m->A, MAT_FINAL_ASSEMBLY));
    PETSC_TRY(MatAssemblyEnd(m->A, MAT_FINAL_ASSEMBLY));
    PETSC_TRY(MatNorm(m->A, NORM_INFINITY, &out->norm));
    PETSC_TRY(PetscNew(&g));
    PETSC_TRY(MatConvert(m->A, MATAIJ, MAT_INITIAL_MATRIX, &g->A));
    PETSC_TRY(MatSetBlockSize(g->A, PETSC_BLOCK));
    PETSC_TRY(MatSetOption(g->A, MAT_SPD, PETSC_TRUE));
    TRY(take_motions(m, g->A, motions));
    TRY(take_solver(g));
    PETSC_TRY(MatGetInfo(g->A, MAT_LOCAL, &info));
    out->bytes = 2.5 * info.memory; // the matrix, its half, and about as much on the grids
    m->grid = g;
    g = NULL;

done:
    petsc_grid_free(g);
    return st;
}

static status check(const petsc_grid *g)
{
    status st = OK;
    KSPConvergedReason reason = KSP_CONVERGED_ITERATING;
    PetscInt steps = 0;
    PetscReal left = 0;
    PETSC_TRY(KSPGetConvergedReason(g->solver, &reason));
    PETSC_TRY(KSPGetIterationNumber(g->solver, &steps));
    PETSC_TRY(KSPGetResidualNorm(g->solver, &left));
    if (reason < 0) {
        TRY(status_fail(ERR_NUMERIC,
                        "segment: conjugate gradients with multigrid stagnate (%s): residual %.2g "
                        "after %d iterations",
                        KSPConvergedReasons[reason], left, (int)steps));
    }

done:
    return st;
}

status petsc_grid_solve(petsc_matrix *m, int ncol, const double *b, double *x)
{
    status st = OK;
    Vec right = NULL, left = NULL;
    const size_t rows = PETSC_BLOCK * (size_t)(m->last - m->first);
    PETSC_TRY(MatCreateVecs(m->grid->A, &left, &right));
    for (int j = 0; j < ncol; j++) {
        PetscInt steps = 0;
        PETSC_TRY(VecPlaceArray(right, b + (size_t)j * rows));
        PETSC_TRY(VecPlaceArray(left, x + (size_t)j * rows));
        const PetscErrorCode code = KSPSolve(m->grid->solver, right, left);
        PETSC_TRY(VecResetArray(right));
        PETSC_TRY(VecResetArray(left));
        PETSC_TRY(code);
        TRY(check(m->grid));
        PETSC_TRY(KSPGetIterationNumber(m->grid->solver, &steps));
        m->grid->steps = (int)steps > m->grid->steps ? (int)steps : m->grid->steps;
    }

done:
    (void)VecDestroy(&right);
    (void)VecDestroy(&left);
    return st;
}

int petsc_matrix_steps(const petsc_matrix *m)
{
    return m->grid ? m->grid->steps : 0;
}
