// tests/unit/fem/test_column.c
#include "base/memory.h"
#include "fem/column.h"
#include "tests/test.h"

#include <string.h>

static const material soft = {.E = 2.6, .nu = 0.3}; // mu = 1, lambda = 1.5

// one quad 2 x 1 with its corner at the origin
static void one_quad(int order, mesh *m)
{
    const shape quad = SHAPE_QUAD;
    const int one = 1;
    element e = {0};
    CHECK_OK(element_make(quad, order, &e));
    CHECK_OK(mesh_make(order, e.nnode, 1, &quad, &one, m));
    for (int i = 0; i < e.nnode; i++) {
        m->xyz[3 * i] = e.node[i][0] + 1;
        m->xyz[3 * i + 1] = (e.node[i][1] + 1) / 2;
        m->block[0].conn[i] = i;
    }
}

static void two_layers(const mesh *plane, int order, column *c)
{
    double node[ELEMENT_MAX_ORDER + 1], level[2 * ELEMENT_MAX_ORDER + 1];
    gauss_lobatto_nodes(order + 1, node);
    for (int k = 0; k <= order; k++) {
        level[k] = (node[k] + 1) / 2;
        level[order + k] = 1 + 2 * (node[k] + 1);
    }
    CHECK_OK(column_make(plane, &soft, order, 2 * order + 1, level, c));
}

static void levels_off_their_places_are_refused(void)
{
    mesh plane = {0};
    column c = {0};
    const double level[] = {0, 0.4, 1}, few[] = {0, 1};
    one_quad(2, &plane);
    CHECK(column_make(&plane, &soft, 2, 3, level, &c) == ERR_BUG);
    status_clear();
    CHECK(column_make(&plane, &soft, 2, 2, few, &c) == ERR_BUG);
    status_clear();
    mesh_free(&plane);
}

static double one_at_a_place(const void *unused, double x, double y, double s)
{
    (void)unused, (void)x, (void)y, (void)s;
    return 2.6;
}

static void directed_and_graded_materials_are_refused_by_name(void)
{
    const double level[] = {0, 1, 2};
    const struct {
        material m;
        const char *words;
    } cases[] = {
        {{.name = "wood", .at = {3, 5}, .E = 1, .kind = MATERIAL_ORTHOTROPIC}, "'wood' is ortho"},
        {{.name = "bone", .at = {3, 5}, .E = 1, .kind = MATERIAL_ANISOTROPIC}, "'bone' is aniso"},
        {{.name = "skin", .at = {3, 5}, .E = 1, .modulus = {.at = one_at_a_place}}, "is graded"},
    };
    mesh plane = {0};
    one_quad(1, &plane);
    for (int i = 0; i < 3; i++) {
        column c = {0};
        int line = 0, place = 0;
        CHECK(column_make(&plane, &cases[i].m, 1, 3, level, &c) == ERR_INPUT);
        CHECK(strstr(status_message(), cases[i].words));
        CHECK(status_place(&line, &place) && line == 3 && place == 5);
        status_clear();
    }
    mesh_free(&plane);
}

// integrals of the basis functions' sum, 1, and of z' = sum of level N'
static void line_matrices_integrate_polynomials(void)
{
    for (int p = 1; p <= ELEMENT_MAX_ORDER; p++) {
        mesh plane = {0};
        column c = {0};
        one_quad(p, &plane);
        two_layers(&plane, p, &c);
        const line_matrices whole = line_matrices_make(&c, 1, 0, 10);
        const line_matrices low = line_matrices_make(&c, 1, 0, 2);
        const line_matrices high = line_matrices_make(&c, 1, 2, 10);
        double length = 0, slope = 0, energy = 0;
        for (int k = 0; k <= p; k++) {
            for (int l = 0; l <= p; l++) {
                const double z = c.level[p + k], y = c.level[p + l];
                length += whole.M[k][l];
                slope += whole.G[k][l] * y;
                energy += whole.K[k][l] * z * y;
                CHECK_WITHIN(low.M[k][l] + high.M[k][l], whole.M[k][l], 1e-14);
                CHECK_WITHIN(low.G[k][l] + high.G[k][l], whole.G[k][l], 1e-13);
                CHECK_WITHIN(low.K[k][l] + high.K[k][l], whole.K[k][l], 1e-12);
            }
        }
        CHECK_NEAR(length, 4.0, 1e-14);
        CHECK_NEAR(slope, 4.0, 1e-13);
        CHECK_NEAR(energy, 4.0, 1e-13);
        CHECK(line_matrices_make(&c, 0, 1.5, 3).M[0][0] == 0); // outside of the layer
        column_free(&c);
        mesh_free(&plane);
    }
}

// displacement of a node of the upper layer under a homogeneous gradient H: u = H x
static double energy_of_gradient(const column *c, const double *K, const double (*H)[3])
{
    const int n = c->plane->nnode, p = c->order, size = 3 * n * (p + 1);
    double u[3 * ELEMENT_MAX_NODES], twice = 0;
    for (int k = 0; k <= p; k++) {
        for (int a = 0; a < n; a++) {
            const double x[3] = {c->plane->xyz[3 * a], c->plane->xyz[3 * a + 1], c->level[p + k]};
            for (int i = 0; i < 3; i++) {
                u[3 * (k * n + a) + i] = H[i][0] * x[0] + H[i][1] * x[1] + H[i][2] * x[2];
            }
        }
    }
    for (int r = 0; r < size; r++) {
        for (int s = 0; s < size; s++) {
            twice += u[r] * K[(size_t)r * (size_t)size + (size_t)s] * u[s];
        }
    }
    return twice;
}

// a homogeneous strain stores strain^T Q strain times the volume, a turn nothing; and K is
// symmetric
static void stiffness_stores_the_strain_energy(void)
{
    const double gradient[4][3][3] = {{{1, 2, 3}, {4, 5, 6}, {7, 8, 10}},
                                      {{0, 0, 0}, {0, 0, 0}, {0, 0, 1}},
                                      {{0, 0, 1}, {0, 0, 0}, {0, 0, 0}},
                                      {{0, -3, 2}, {3, 0, -1}, {-2, 1, 0}}};
    for (int p = 1; p <= ELEMENT_MAX_ORDER; p++) {
        mesh plane = {0};
        column c = {0};
        plane_matrices *m = NULL;
        double *K = NULL;
        const size_t size = 3 * (size_t)element_node_count(SHAPE_HEX, p);
        CHECK_OK(TAKE(m, 1));
        CHECK_OK(TAKE(K, size * size));
        one_quad(p, &plane);
        two_layers(&plane, p, &c);
        CHECK_OK(plane_matrices_make(&c, 0, 0, m));
        const line_matrices line = line_matrices_make(&c, 1, 1, 5);
        element_stiffness(m, &line, p, K);
        for (int g = 0; g < 4; g++) {
            const double(*H)[3] = gradient[g];
            const mat6 Q = material_stiffness(&soft);
            const vec6 e = {{H[0][0], H[1][1], H[2][2], H[1][2] + H[2][1], H[0][2] + H[2][0],
                             H[0][1] + H[1][0]}};
            const double wanted = 2 * 1 * 4 * vec6_dot(e, mat6_mul_vec(Q, e));
            CHECK_WITHIN(energy_of_gradient(&c, K, H), wanted, 1e-9); // rounding of sums near 1e4
        }
        for (size_t r = 0; r < size; r++) {
            for (size_t s = 0; s < r; s++) {
                CHECK_WITHIN(K[r * size + s], K[s * size + r], 1e-13);
            }
        }
        free(m);
        free(K);
        column_free(&c);
        mesh_free(&plane);
    }
}

static void an_inverted_element_is_refused(void)
{
    mesh plane = {0};
    column c = {0};
    plane_matrices *m = NULL;
    CHECK_OK(TAKE(m, 1));
    one_quad(1, &plane);
    plane.xyz[0] = 3;
    two_layers(&plane, 1, &c);
    CHECK(plane_matrices_make(&c, 0, 0, m) == ERR_NUMERIC);
    status_clear();
    free(m);
    column_free(&c);
    mesh_free(&plane);
}

static void a_lower_column_has_the_same_layers(void)
{
    mesh plane = {0}, lower_plane = {0};
    column c = {0}, lower = {0};
    one_quad(4, &plane);
    two_layers(&plane, 4, &c);
    CHECK_OK(column_lower(&c, 2, &lower_plane, &lower));
    CHECK(lower.nlevel == 5 && lower.nlayer == 2 && lower_plane.nnode == 9);
    CHECK_WITHIN(lower.level[1], 0.5, 1e-15);
    CHECK_WITHIN(lower.level[2], 1.0, 1e-15);
    CHECK_WITHIN(lower.level[4], 5.0, 1e-15);
    column_free(&lower);
    column_free(&c);
    mesh_free(&lower_plane);
    mesh_free(&plane);
}

int main(void)
{
    levels_off_their_places_are_refused();
    directed_and_graded_materials_are_refused_by_name();
    line_matrices_integrate_polynomials();
    stiffness_stores_the_strain_energy();
    an_inverted_element_is_refused();
    a_lower_column_has_the_same_layers();
    return test_failures != 0;
}
