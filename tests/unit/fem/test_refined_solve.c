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

static const double b[COLUMNS * N] = {1, 2, 3e-7, -4, 5, 6e-7};

static status residual(void *self, const double *x, double *r)
{
    const petsc_matrix *m = (const petsc_matrix *)self;
    for (int i = 0; i < N * COLUMNS; i++) {
        r[i] = (double)(b[i] - (long double)m->diagonal[i % N] * x[i]);
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

static const petsc_door door = {.agree = agree, .largest = largest, .matrix_solve = solve};

static refined_system system_of(petsc_matrix *m)
{
    return (refined_system){.door = &door,
                            .matrix = m,
                            .norm = 2,
                            .n = N,
                            .ncol = COLUMNS,
                            .b = b,
                            .residual = residual,
                            .self = m};
}

static void one_step_restores_the_soft_direction(void)
{
    petsc_matrix m = {.diagonal = {1, 2, 3e-7}, .wrong = 1e-8};
    const refined_system s = system_of(&m);
    double x[COLUMNS * N];
    refined_answer answer = {0};
    CHECK_OK(refined_solve(&s, x, &answer));
    for (int i = 0; i < COLUMNS * N; i++) {
        CHECK_NEAR(x[i], b[i] / m.diagonal[i % N], 1e-15); // 1e-8 squared, and rounding
    }
    // |r| over |A| |x| + |b|: 3e-15 / (2 + 2) in the first column, 6e-15 / (8 + 5) in the second
    CHECK_NEAR(answer.residual, 3e-15 / 4, 1e-6);
    CHECK_NEAR(answer.moved, 1e-8, 1e-6); // of 1, in the first
}

static void a_large_residual_is_a_failure(void)
{
    petsc_matrix m = {.diagonal = {1, 2, 3e-7}, .wrong = 1e-3};
    const refined_system s = system_of(&m);
    double x[COLUMNS * N];
    refined_answer answer = {0};
    CHECK(refined_solve(&s, x, &answer) == ERR_NUMERIC);
    status_clear();
    m.wrong = NAN;
    CHECK(refined_solve(&s, x, &answer) == ERR_NUMERIC);
    status_clear();
}

// factors of a direction that hardly resists: what one step changes is no small part of x
static void an_all_but_free_direction_is_a_failure(void)
{
    petsc_matrix m = {.diagonal = {1, 2, 1e-13}, .wrong = 0.1};
    const refined_system s = system_of(&m);
    double x[COLUMNS * N];
    refined_answer answer = {0};
    CHECK(refined_solve(&s, x, &answer) == ERR_NUMERIC);
    status_clear();
}

int main(void)
{
    one_step_restores_the_soft_direction();
    a_large_residual_is_a_failure();
    an_all_but_free_direction_is_a_failure();
    return test_failures != 0;
}
