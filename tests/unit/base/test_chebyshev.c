// tests/unit/base/test_chebyshev.c
#include "base/chebyshev.h"
#include "tests/test.h"

// n nodes are exact to degree n - 1, derivative included, at and between the nodes
static void polynomials_are_exact(void)
{
    double value[CHEBYSHEV_MAX_NODES], slope[CHEBYSHEV_MAX_NODES];
    for (int n = 2; n <= CHEBYSHEV_MAX_NODES; n++) {
        for (int k = 0; k < 9; k++) {
            const double t = k < 3 ? chebyshev_node(n, k % n) : -1 + 0.24 * k;
            chebyshev_weights(n, t, value, slope);
            double p = 0, dp = 0;
            for (int i = 0; i < n; i++) {
                const double at_node = pow(chebyshev_node(n, i), n - 1);
                p += value[i] * at_node;
                dp += slope[i] * at_node;
            }
            CHECK_WITHIN(p, pow(t, n - 1), 1e-13);
            CHECK_WITHIN(dp, (n - 1) * pow(t, n - 2), 1e-12 * n * n);
        }
    }
}

// one degree more is not: the error of t^n is the known polynomial (t^2 - 1) U_{n-2}(t) / 2^{n-2}
static void the_next_degree_has_the_known_error(void)
{
    const int n = 6;
    const double t = 0.3;
    double value[CHEBYSHEV_MAX_NODES];
    chebyshev_weights(n, t, value, NULL);
    double p = 0;
    for (int i = 0; i < n; i++) {
        p += value[i] * pow(chebyshev_node(n, i), n);
    }
    const double U = sin((n - 1) * acos(t)) / sin(acos(t));
    CHECK_NEAR(pow(t, n) - p, (t * t - 1) * U / 16, 1e-12);
}

static void coefficients_of_a_sum_of_chebyshev_polynomials(void)
{
    double at_node[7], c[7];
    for (int i = 0; i < 7; i++) {
        const double t = chebyshev_node(7, i);
        at_node[i] = 3 + 2 * t - 5 * cos(4 * acos(t)) + 0.5 * cos(6 * acos(t));
    }
    chebyshev_coefficients(7, at_node, c);
    const double wanted[7] = {3, 2, 0, 0, -5, 0, 0.5};
    for (int k = 0; k < 7; k++) {
        CHECK_WITHIN(c[k], wanted[k], 1e-14);
    }
    chebyshev_coefficients(1, at_node, c);
    CHECK(c[0] == at_node[0]);
}

int main(void)
{
    polynomials_are_exact();
    the_next_degree_has_the_known_error();
    coefficients_of_a_sum_of_chebyshev_polynomials();
    return test_failures != 0;
}
