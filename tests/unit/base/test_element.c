// tests/unit/base/test_element.c
#include "base/element.h"
#include "tests/test.h"

#include <string.h>

static const shape all[] = {SHAPE_LINE, SHAPE_TRIANGLE, SHAPE_QUAD, SHAPE_PRISM, SHAPE_HEX};

// a polynomial of total degree p and its gradient
static double polynomial(int p, const double *x, double *gradient)
{
    const double a[3] = {0.3, -0.2, 0.45};
    const double t = 0.9 + a[0] * x[0] + a[1] * x[1] + a[2] * x[2];
    for (int d = 0; d < 3; d++) {
        gradient[d] = p * pow(t, p - 1) * a[d];
    }
    return pow(t, p);
}

static void basis_is_one_at_its_node(shape s, int p)
{
    element e;
    CHECK_OK(element_make(s, p, &e));
    for (int i = 0; i < e.nnode; i++) {
        double N[ELEMENT_MAX_NODES];
        element_basis(&e, e.node[i], N, NULL);
        for (int k = 0; k < e.nnode; k++) {
            CHECK_WITHIN(N[k], i == k, 1e-13);
        }
    }
}

static void basis_holds_polynomials_of_its_order(shape s, int p)
{
    element e;
    CHECK_OK(element_make(s, p, &e));
    const double x[3] = {0.21, s == SHAPE_LINE ? 0 : 0.34, e.dim == 3 ? -0.4 : 0};
    double N[ELEMENT_MAX_NODES], dN[3 * ELEMENT_MAX_NODES], wanted[3], unused[3];
    element_basis(&e, x, N, dN);
    double value = 0, gradient[3] = {0};
    for (int k = 0; k < e.nnode; k++) {
        const double f = polynomial(p, e.node[k], unused);
        value += N[k] * f;
        for (int d = 0; d < e.dim; d++) {
            gradient[d] += dN[k * e.dim + d] * f;
        }
    }
    CHECK_NEAR(value, polynomial(p, x, wanted), 1e-12);
    for (int d = 0; d < e.dim; d++) {
        CHECK_NEAR(gradient[d], wanted[d], 1e-12);
    }
}

static double factorial(int n)
{
    return n < 2 ? 1 : n * factorial(n - 1);
}

// int x^a (1+y)^b (1+z)^c, closed
static double exact_moment(shape s, int a, int b, int c)
{
    const double line_a = a % 2 ? 0 : 2.0 / (a + 1);
    const double line_b = pow(2, b + 1) / (b + 1), line_c = pow(2, c + 1) / (c + 1);
    // triangle: int x^a y^k = a! k! / (a + k + 2)!
    double triangle = 0;
    for (int k = 0; k <= b; k++) {
        triangle += factorial(b) / (factorial(k) * factorial(b - k)) * factorial(a) * factorial(k) /
                    factorial(a + k + 2);
    }
    switch (s) {
    case SHAPE_LINE:
        return line_a;
    case SHAPE_TRIANGLE:
        return triangle;
    case SHAPE_QUAD:
        return line_a * line_b;
    case SHAPE_PRISM:
        return triangle * line_c;
    case SHAPE_HEX:
        return line_a * line_b * line_c;
    }
    return 0;
}

// every x^a (1 + y)^b (1 + z)^c of the degree
static void quadrature_is_exact_to_its_degree(shape s, int degree)
{
    element e;
    basis_table t = {0};
    CHECK_OK(element_make(s, 1, &e));
    CHECK_OK(basis_table_make(&e, degree, &t));
    for (int b = 0; b <= (e.dim > 1 ? degree : 0); b++) {
        const int a = degree - b, c = e.dim > 2 ? degree : 0;
        double sum = 0;
        for (int q = 0; q < t.npoint; q++) {
            const double *x = t.point + q * t.dim;
            const double y = e.dim > 1 ? x[1] : 0, z = e.dim > 2 ? x[2] : 0;
            sum += t.weight[q] * pow(x[0], a) * pow(1 + y, b) * pow(1 + z, c);
            CHECK(t.weight[q] > 0);
        }
        // rounding of terms as large as 2^(b + c)
        CHECK_WITHIN(sum, exact_moment(s, a, b, c), 1e-14 * pow(2, b + c + 3));
    }
    basis_table_free(&t);
}

static void edge_nodes_are_lobatto_points(void)
{
    element e;
    double g[5];
    gauss_lobatto_nodes(5, g);
    CHECK_NEAR(g[3], sqrt(3.0 / 7), 1e-15);
    CHECK_OK(element_make(SHAPE_TRIANGLE, 4, &e));
    for (int i = 0; i < 5; i++) {
        CHECK_WITHIN(e.node[i][0], (1 + g[i]) / 2, 1e-15);
        CHECK_WITHIN(e.node[i][1], 0, 1e-15);
    }
}

static void wrong_orders_are_refused(void)
{
    element e;
    basis_table t = {0};
    CHECK(element_make(SHAPE_HEX, 0, &e) == ERR_BUG);
    CHECK(element_make(SHAPE_HEX, 5, &e) == ERR_BUG);
    CHECK_OK(element_make(SHAPE_HEX, 1, &e));
    CHECK(basis_table_make(&e, 400, &t) == ERR_BUG);
    status_clear();
}

int main(void)
{
    for (int i = 0; i < 5; i++) {
        for (int p = 1; p <= 4; p++) {
            basis_is_one_at_its_node(all[i], p);
            basis_holds_polynomials_of_its_order(all[i], p);
        }
        for (int degree = 0; degree <= 12; degree++) {
            quadrature_is_exact_to_its_degree(all[i], degree);
        }
    }
    edge_nodes_are_lobatto_points();
    wrong_orders_are_refused();
    return test_failures != 0;
}
