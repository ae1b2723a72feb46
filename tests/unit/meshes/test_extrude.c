// tests/unit/meshes/test_extrude.c
#include "base/dense.h"
#include "tests/shapes.h"
#include "tests/test.h"

static double volume(const mesh *m)
{
    const mesh_block *b = &m->block[0];
    element e = {0};
    basis_table t = {0};
    double sum = 0;
    CHECK_OK(element_make(b->shape, m->order, &e));
    CHECK_OK(basis_table_make(&e, 2 * m->order + 1, &t));
    for (int k = 0; k < b->nelem; k++) {
        for (int q = 0; q < t.npoint; q++) {
            mat3 J = {0};
            for (int i = 0; i < t.nnode; i++) {
                const double *p = m->xyz + 3 * (size_t)b->conn[k * t.nnode + i];
                for (int r = 0; r < 9; r++) {
                    J.a[r / 3][r % 3] += p[r / 3] * t.dN[3 * (q * t.nnode + i) + r % 3];
                }
            }
            const vec3 row[3] = {{{J.a[0][0], J.a[0][1], J.a[0][2]}},
                                 {{J.a[1][0], J.a[1][1], J.a[1][2]}},
                                 {{J.a[2][0], J.a[2][1], J.a[2][2]}}};
            sum += t.weight[q] * vec3_dot(row[0], vec3_cross(row[1], row[2]));
        }
    }
    basis_table_free(&t);
    return sum;
}

static void volume_is_area_times_length(void)
{
    const shape_spec ring[] = {an_annulus(4e-3, 3.2e-3, 0), a_sector(4e-3, 3.2e-3, PI, PI / 8, 1)};
    const shape_spec bar[] = {a_disc(2e-3, 1e-4, 0, 0), a_disc(0.5e-3, 0.5e-3, 0, 1)};
    for (int p = 1; p <= 4; p++) {
        for (int kind = MESH_MAPPED; kind <= MESH_FREE; kind++) {
            mesh plane = {0}, solid = {0};
            double *z = NULL;
            const extrude_options options = {.length = 20e-3, .layers = 5, .grading = 3};
            CHECK_OK(mesh_of(2, kind == MESH_MAPPED ? ring : bar, kind, p, 2e-3, &plane));
            CHECK_OK(mesh_extrude(&plane, &options, &solid, &z));
            CHECK_OK(mesh_check(&solid));
            CHECK(solid.dim == 3 && solid.nnode == plane.nnode * (5 * p + 1));
            CHECK(solid.block[0].shape == (kind == MESH_MAPPED ? SHAPE_HEX : SHAPE_PRISM));
            CHECK_NEAR(volume(&solid), 20e-3 * mesh_moments(&plane, -1).a[0], 1e-13);
            // node and element numbers as promised
            const int n = plane.block[0].nelem, per = plane.block[0].per_elem;
            for (int e = 0; e < 5 * n; e++) {
                const int *to = solid.block[0].conn + (size_t)e * (size_t)solid.block[0].per_elem;
                const int *from = plane.block[0].conn + (size_t)(e % n) * (size_t)per;
                for (int i = 0; i < per * (p + 1); i++) {
                    CHECK(to[i] == from[i % per] + plane.nnode * (e / n * p + i / per));
                }
                CHECK(solid.block[0].material[e] == plane.block[0].material[e % n]);
            }
            for (int i = 0; i < solid.nnode; i++) {
                CHECK(solid.xyz[3 * i + 2] == z[i / plane.nnode]);
            }
            free(z);
            mesh_free(&plane);
            mesh_free(&solid);
        }
    }
}

static void layers_grow_from_both_ends(void)
{
    const shape_spec plate = a_rectangle(1, 1, 0, 0, 0, 0);
    mesh plane = {0};
    CHECK_OK(mesh_of(1, &plate, MESH_AUTO, 3, 1, &plane));
    for (int layers = 2; layers <= 9; layers++) {
        mesh solid = {0};
        double *z = NULL;
        const extrude_options options = {.length = 2, .layers = layers, .grading = 8};
        CHECK_OK(mesh_extrude(&plane, &options, &solid, &z));
        CHECK(z[0] == 0 && z[3 * layers] == 2);
        const double first = z[3] - z[0], second = z[6] - z[3];
        const int middle = (layers - 1) / 2;
        if (middle > 0) {
            CHECK_NEAR((z[3 * middle + 3] - z[3 * middle]) / first, 8, 1e-12);
            CHECK_NEAR(second / first, pow(8, 1.0 / middle), 1e-12);
        }
        for (int k = 0; k <= 3 * layers; k++) {
            CHECK_WITHIN(z[k] + z[3 * layers - k], 2, 1e-15); // symmetric
        }
        // Lobatto points of order 3 within a layer
        CHECK_NEAR((z[1] - z[0]) / first, (1 - 1 / sqrt(5)) / 2, 1e-13);
        free(z);
        mesh_free(&solid);
    }
    mesh_free(&plane);
}

static void bad_options_are_refused(void)
{
    const shape_spec plate = a_rectangle(1, 1, 0, 0, 0, 0);
    mesh plane = {0}, solid = {0};
    CHECK_OK(mesh_of(1, &plate, MESH_AUTO, 2, 1, &plane));
    const extrude_options bad[] = {
        {.length = 0, .layers = 2, .grading = 1},
        {.length = NAN, .layers = 2, .grading = 1},
        {.length = 1, .layers = 1, .grading = 1},
        {.length = 1, .layers = 2, .grading = 0.5},
        {.length = 1, .layers = 2, .grading = 1, .order = 3},
    };
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        CHECK(mesh_extrude(&plane, &bad[i], &solid, NULL) == ERR_INPUT);
        status_clear();
    }
    mesh_free(&plane);
}

int main(void)
{
    volume_is_area_times_length();
    layers_grow_from_both_ends();
    bad_options_are_refused();
    return test_failures != 0;
}
