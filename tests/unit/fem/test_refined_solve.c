// tests/unit/fem/test_refined_solve.c
// Refinement with a door of our own: a diagonal matrix whose "factors" are wrong in the eighth
// digit of a soft direction.
#include "fem/refined_solve.h"
#include "tests/test.h"

#include <math.h>

enum { N = 3, COLUMNS = 2 };

struct petsc_matrix {
    double diagonal[N];
    double wrong; // relative, of the last one's factor
};

static status solve(petsc_matrix *m, int ncol, const double *b, double *x)
{
    for (int i = 0; i < N * ncol; i++) {
        x[i] = b[i] / m->diagonal[i % N] * (i % N == N - 1 ? 1 + m->wrong : 1);
    }
    return OK;
}

static status multiply(petsc_matrix *m, int ncol, const double *x, long double *y)
{
    for (int i = 0; i < N * ncol; i++) {
        y[i] = (long double)m->diagonal[i / ncol] * x[i];
    }
    return OK;
}

static status agree(status mine)
{
    return mine;
}

static void largest(int n, double *v)
{
    (void)n;
    (void)v;
}

static const petsc_door door = {
    .agree = agree, .largest = largest, .matrix_solve = solve, .matrix_multiply = multiply};
static const double b[COLUMNS * N] = {1, 2, 3e-7, -4, 5, 6e-7};

static void one_step_restores_the_soft_direction(void)
{
    petsc_matrix m = {.diagonal = {1, 2, 3e-7}, .wrong = 1e-8};
    double x[COLUMNS * N], relative = 0;
    CHECK_OK(refined_solve(&door, &m, 2, N, COLUMNS, b, x, &relative));
    for (int i = 0; i < COLUMNS * N; i++) {
        CHECK_NEAR(x[i], b[i] / m.diagonal[i % N], 1e-15); // 1e-8 squared, and rounding
    }
    // |r| over |A| |x| + |b|: 3e-15 / (2 + 2) in the first column, 6e-15 / (8 + 5) in the second
    CHECK_NEAR(relative, 3e-15 / 4, 1e-6);
}

static void a_large_residual_is_a_failure(void)
{
    petsc_matrix m = {.diagonal = {1, 2, 3e-7}, .wrong = 1e-3};
    double x[COLUMNS * N], relative = 0;
    CHECK(refined_solve(&door, &m, 2, N, COLUMNS, b, x, &relative) == ERR_NUMERIC);
    status_clear();
    m.wrong = NAN;
    CHECK(refined_solve(&door, &m, 2, N, COLUMNS, b, x, &relative) == ERR_NUMERIC);
    status_clear();
}

int main(void)
{
    one_step_restores_the_soft_direction();
    a_large_residual_is_a_failure();
    return test_failures != 0;
}
