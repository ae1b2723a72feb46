// tests/unit/base/test_mesh.c
#include "base/mesh.h"
#include "tests/test.h"

#include <string.h>

// a smooth map of the unit square that keeps det J > 0
static void bend(double x, double y, double *out)
{
    out[0] = x + 0.1 * y * y;
    out[1] = y - 0.1 * x * x;
    out[2] = 0;
}

// n x n quads or 2 n^2 triangles of order p over the bent unit square, nodes on one lattice of
// Lobatto points
static void bent_square(shape s, int p, int n, mesh *m)
{
    element e;
    CHECK_OK(element_make(s, p, &e));
    const int per_side = n * p + 1;
    const int nelem = s == SHAPE_QUAD ? n * n : 2 * n * n;
    CHECK_OK(mesh_make(p, per_side * per_side, 1, &s, &nelem, m));
    for (int j = 0; j < per_side; j++) {
        for (int i = 0; i < per_side; i++) {
            const double x = (i / p + (1 + e.line_node[i % p]) / 2) / n;
            const double y = (j / p + (1 + e.line_node[j % p]) / 2) / n;
            bend(x, y, m->xyz + 3 * (j * per_side + i));
        }
    }
    int at = 0;
    for (int k = 0; k < n * n; k++) {
        const int corner = (k / n) * p * per_side + (k % n) * p;
        if (s == SHAPE_QUAD) {
            for (int j = 0; j <= p; j++) {
                for (int i = 0; i <= p; i++) {
                    m->block[0].conn[at++] = corner + j * per_side + i;
                }
            }
            continue;
        }
        for (int half = 0; half < 2; half++) {
            for (int j = 0; j <= p; j++) {
                for (int i = 0; i <= p - j; i++) {
                    const int a = half ? p - i : i, b = half ? p - j : j;
                    m->block[0].conn[at++] = corner + b * per_side + a;
                }
            }
        }
    }
}

static double mesh_area(const mesh *m)
{
    element e;
    basis_table t = {0};
    double area = 0;
    CHECK_OK(element_make(m->block[0].shape, m->order, &e));
    CHECK_OK(basis_table_make(&e, 2 * m->order, &t));
    for (int k = 0; k < m->block[0].nelem; k++) {
        const int *conn = m->block[0].conn + k * e.nnode;
        for (int q = 0; q < t.npoint; q++) {
            double J[2][2] = {{0}};
            for (int i = 0; i < e.nnode; i++) {
                for (int a = 0; a < 2; a++) {
                    for (int b = 0; b < 2; b++) {
                        J[a][b] += m->xyz[3 * conn[i] + a] * t.dN[(q * e.nnode + i) * 2 + b];
                    }
                }
            }
            area += t.weight[q] * (J[0][0] * J[1][1] - J[0][1] * J[1][0]);
        }
    }
    basis_table_free(&t);
    return area;
}

// dx dy = (1 + 4 * 0.01 x y) dX dY over the unit square
static const double exact_area = 1 + 0.01;

static void a_bent_square_has_its_area(shape s, int p)
{
    mesh m = {0};
    bent_square(s, p, 3, &m);
    CHECK_OK(mesh_check(&m));
    // the map is quadratic: exact from order 2 on for quads, whose basis is a product
    CHECK_NEAR(mesh_area(&m), exact_area, p >= 2 ? 1e-3 : 2e-2);
    if (s == SHAPE_QUAD && p >= 2) {
        CHECK_NEAR(mesh_area(&m), exact_area, 1e-13);
    }
    mesh_free(&m);
}

static void lowering_the_order_keeps_shared_nodes_single(shape s)
{
    for (int p = 2; p <= 4; p++) {
        for (int low = 1; low < p; low++) {
            mesh m = {0}, l = {0};
            bent_square(s, p, 3, &m);
            CHECK_OK(mesh_of_order(&m, low, &l));
            CHECK(l.nnode == (3 * low + 1) * (3 * low + 1));
            CHECK_OK(mesh_check(&l));
            // orders >= 2 hold the quadratic map exactly on quads
            if (low >= 2 && s == SHAPE_QUAD) {
                CHECK_NEAR(mesh_area(&l), exact_area, 1e-13);
            }
            mesh_free(&m);
            mesh_free(&l);
        }
    }
}

static void an_inverted_element_is_found(void)
{
    mesh m = {0};
    bent_square(SHAPE_QUAD, 2, 2, &m);
    double ratio;
    CHECK_OK(mesh_min_jacobian(&m, &ratio));
    CHECK(ratio > 0.5 && ratio <= 1);
    m.xyz[3 * 12] = 3; // the centre node flies off
    CHECK(mesh_check(&m) == ERR_NUMERIC);
    status_clear();
    CHECK_OK(mesh_min_jacobian(&m, &ratio));
    CHECK(ratio <= 0);
    mesh_free(&m);
}

// the lower half of det J's range that is wrong: elements turned inside out as a whole, and a fold
// that is hardly seen
static void inside_out_and_slightly_folded_are_inverted(void)
{
    for (int p = 1; p <= 3; p++) {
        for (int s = 0; s < 2; s++) {
            mesh m = {0};
            double ratio;
            bent_square(s ? SHAPE_QUAD : SHAPE_TRIANGLE, p, 2, &m);
            CHECK_OK(mesh_check(&m));
            for (int i = 0; i < m.nnode; i++) {
                m.xyz[3 * i] = -m.xyz[3 * i];
            }
            CHECK(mesh_check(&m) == ERR_NUMERIC);
            CHECK(strstr(status_message(), "is inverted") != NULL);
            status_clear();
            CHECK_OK(mesh_min_jacobian(&m, &ratio));
            CHECK(ratio < 0);
            mesh_free(&m);
        }
    }
    // one corner pulled over the diagonal of a single square: det J is 1 + (c - 1)(x + y) for the
    // corner at (c, c)
    const double corner[3] = {0.55, 0.45, 0.2};
    for (int k = 0; k < 3; k++) {
        mesh m = {0};
        double ratio;
        const shape quad = SHAPE_QUAD;
        const int one = 1;
        CHECK_OK(mesh_make(1, 4, 1, &quad, &one, &m));
        for (int i = 0; i < 4; i++) {
            m.block[0].conn[i] = i;
            m.xyz[3 * i] = i == 3 ? corner[k] : i % 2;
            m.xyz[3 * i + 1] = i == 3 ? corner[k] : (double)(i / 2);
        }
        CHECK_OK(mesh_min_jacobian(&m, &ratio));
        CHECK_NEAR(ratio, (2 * corner[k] - 1) / corner[k], 1e-12);
        CHECK(mesh_check(&m) == (k == 0 ? OK : ERR_NUMERIC));
        status_clear();
        mesh_free(&m);
    }
}

static void wrong_meshes_are_refused(void)
{
    mesh m = {0};
    bent_square(SHAPE_QUAD, 1, 2, &m);
    m.block[0].conn[3] = 9;
    CHECK(mesh_check(&m) == ERR_NUMERIC);
    status_clear();
    m.block[0].conn[3] = 4;
    m.xyz[0] = NAN;
    CHECK(mesh_check(&m) == ERR_NUMERIC);
    status_clear();
    mesh_free(&m);
    CHECK(mesh_check(&m) == ERR_NUMERIC);
    status_clear();
    mesh_free(&m);
}

int main(void)
{
    for (int p = 1; p <= 4; p++) {
        a_bent_square_has_its_area(SHAPE_QUAD, p);
        a_bent_square_has_its_area(SHAPE_TRIANGLE, p);
    }
    lowering_the_order_keeps_shared_nodes_single(SHAPE_QUAD);
    lowering_the_order_keeps_shared_nodes_single(SHAPE_TRIANGLE);
    an_inverted_element_is_found();
    inside_out_and_slightly_folded_are_inverted();
    wrong_meshes_are_refused();
    return test_failures != 0;
}
