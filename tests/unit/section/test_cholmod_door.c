// tests/unit/section/test_cholmod_door.c
#include "section/cholmod_door.h"
#include "tests/test.h"

enum { N = 50 };

// -1 2 -1 with `first` as the first diagonal entry
static sparse_lower chain(double first, int *start, int *row, double *value)
{
    int k = 0;
    for (int j = 0; j < N; j++) {
        start[j] = k;
        row[k] = j;
        value[k++] = j ? 2 : first;
        if (j + 1 < N) {
            row[k] = j + 1;
            value[k++] = -1;
        }
    }
    start[N] = k;
    return (sparse_lower){.n = N, .start = start, .row = row, .value = value};
}

// -u'' = 1 with u = 0 beyond both ends: u_i = (i + 1) (N - i) / 2, exact on the grid
static void solves_several_columns(void)
{
    int start[N + 1], row[2 * N];
    double value[2 * N], b[2 * N], x[2 * N];
    const sparse_lower a = chain(2, start, row, value);
    cholesky *c = NULL;
    CHECK_OK(cholesky_make(&a, &c));
    for (int i = 0; i < N; i++) {
        b[i] = 1;
        b[N + i] = 2;
    }
    CHECK_OK(cholesky_solve(c, 2, N, b, x));
    for (int i = 0; i < N; i++) {
        CHECK_NEAR(x[i], (i + 1) * (N - i) / 2.0, 1e-12);
        CHECK_NEAR(x[N + i], (i + 1) * (N - i), 1e-12);
    }
    CHECK_OK(cholesky_solve(c, 2, N, b, b));
    CHECK(b[N + 7] == x[N + 7]);
    cholesky_free(c);
}

static void orders_are_permutations(void)
{
    int start[N + 1], row[2 * N], order[N], seen[N] = {0};
    double value[2 * N];
    const sparse_lower a = chain(2, start, row, value);
    CHECK_OK(cholesky_order(&a, order));
    for (int i = 0; i < N; i++) {
        seen[order[i]]++;
    }
    for (int i = 0; i < N; i++) {
        CHECK(seen[i] == 1);
    }
}

// A chain that is free at both ends can move as a whole; in tenths its last pivot is rounding.
static void refuses_singular_and_indefinite(void)
{
    int start[N + 1], row[2 * N];
    double value[2 * N];
    for (int k = 0; k < 2; k++) {
        const sparse_lower a = chain(k == 0 ? 1 : -1, start, row, value);
        cholesky *c = NULL;
        value[start[N - 1]] = 1;
        for (int i = 0; i < start[N]; i++) {
            value[i] *= 0.1;
        }
        CHECK(cholesky_make(&a, &c) == ERR_NUMERIC);
        CHECK(c == NULL);
        status_clear();
    }
}

// A Hermitian chain with phases: D^H A D with D = diag(i^j) has the solutions D^H x.
static void solves_hermitian_systems(void)
{
    int start[N + 1], row[2 * N];
    double value[2 * N], pair[4 * N], b[4 * N], x[4 * N];
    const double phase[4][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    sparse_lower a = chain(2, start, row, value);
    for (int k = 0; k < start[N]; k++) {
        // below the diagonal conj(i^(j + 1)) i^j = -i
        const int diagonal = value[k] > 0;
        pair[2 * k] = diagonal ? value[k] : 0;
        pair[2 * k + 1] = diagonal ? 0 : -value[k];
    }
    a.value = pair;
    a.complex = true;
    for (int i = 0; i < 2 * N; i++) { // conj(i^j), and twice that
        b[i] = i % 2 ? -phase[i / 2 % 4][1] : phase[i / 2 % 4][0];
        b[2 * N + i] = 2 * b[i];
    }
    cholesky *c = NULL;
    CHECK_OK(cholesky_make(&a, &c));
    CHECK_OK(cholesky_solve(c, 2, N, b, x));
    for (int i = 0; i < 4 * N; i++) {
        const int j = i % (2 * N) / 2;
        CHECK_WITHIN(x[i], (j + 1) * (N - j) / 2.0 * b[i], 1e-10);
    }
    cholesky_free(c);
}

int main(void)
{
    solves_hermitian_systems();
    solves_several_columns();
    orders_are_permutations();
    refuses_singular_and_indefinite();
    return test_failures != 0;
}
