// tests/unit/fem/test_body_solid.c
#include "base/memory.h"
#include "fem/body_solid.h"
#include "tests/test.h"

static const material materials[2] = {{.E = 1, .nu = 0.3}, {.E = 2, .nu = 0.3}};

// a strip of n quads side by side, each 1/2 x 1, material 0 and 1 by turns
static status strip(int n, int p, mesh *out)
{
    status st = OK;
    const shape quad = SHAPE_QUAD;
    element e = {0};
    mesh m = {0};
    const int row = n * p + 1;
    TRY(element_make(quad, p, &e));
    TRY(mesh_make(p, row * (p + 1), 1, &quad, &n, &m));
    for (int k = 0; k < n * e.nnode; k++) {
        const int at = k / e.nnode, i = k % e.nnode % (p + 1), j = k % e.nnode / (p + 1);
        const int node = j * row + at * p + i;
        m.block[0].conn[k] = node;
        m.block[0].material[at] = at % 2;
        m.xyz[3 * node] = (at + (e.node[k % e.nnode][0] + 1) / 2) / 2;
        m.xyz[3 * node + 1] = e.node[k % e.nnode][1] / 2;
    }
    *out = m;

done:
    return st;
}

// what is tall curves: x moves by a parabola, exact in order 2 that curves: x by a parabola, exact
// in order 2
static status lean(const void *self, double s, double *xyz, mat3 *axes, double origin[3])
{
    const mesh *m = self;
    for (int i = 0; i < m->nnode; i++) {
        xyz[3 * i] = m->xyz[3 * i] + s * s;
        xyz[3 * i + 1] = m->xyz[3 * i + 1];
        xyz[3 * i + 2] = s;
    }
    *axes = mat3_identity();
    origin[0] = s * s;
    origin[1] = 0;
    origin[2] = s;
    return OK;
}

static double volume(const mesh *m)
{
    double sum = 0;
    for (int k = 0; k < m->nblock; k++) {
        const mesh_block *b = &m->block[k];
        element e = {0};
        basis_table t = {0};
        CHECK_OK(element_make(b->shape, m->order, &e));
        CHECK_OK(basis_table_make(&e, 3 * m->order, &t));
        for (int i = 0; i < b->nelem * t.npoint; i++) {
            const int *conn = b->conn + (size_t)(i / t.npoint) * (size_t)b->per_elem;
            const double *dN = t.dN + 3 * (size_t)(i % t.npoint) * (size_t)t.nnode;
            double J[3][3] = {{0}};
            for (int n = 0; n < t.nnode; n++) {
                for (int r = 0; r < 9; r++) {
                    J[r / 3][r % 3] +=
                        dN[3 * n + r / 3] * m->xyz[3 * (size_t)conn[n] + (size_t)(r % 3)];
                }
            }
            const vec3 u = {{J[0][0], J[0][1], J[0][2]}}, v = {{J[1][0], J[1][1], J[1][2]}},
                       w = {{J[2][0], J[2][1], J[2][2]}};
            sum += t.weight[i % t.npoint] * vec3_dot(vec3_cross(u, v), w);
        }
        basis_table_free(&t);
    }
    return sum;
}

static void its_volume_is_the_bodys(void)
{
    const double layer[] = {0, 0.5, 1.7, 2};
    for (int p = 1; p <= 4; p++) {
        for (int along = 1; along <= 4; along++) {
            mesh plane = {0}, solid = {0};
            body b = {0};
            CHECK_OK(strip(4, p, &plane));
            const body_spec spec = {.plane = &plane,
                                    .materials = materials,
                                    .order = along,
                                    .nlayer = 3,
                                    .layer = layer,
                                    .shape = {.self = &plane, .place = lean}};
            CHECK_OK(body_make(&spec, &b));
            CHECK_OK(body_solid(&b, &solid));
            CHECK_OK(mesh_check(&solid));
            CHECK_NEAR(volume(&solid), 4, 1e-12); // leaning changes none
            CHECK(solid.nnode == plane.nnode * (3 * p + 1) && solid.order == p);
            // a value linear in s stays one
            double *held = NULL, *there = NULL;
            CHECK_OK(TAKE(held, 2 * body_node_count(&b)));
            CHECK_OK(TAKE(there, 2 * (size_t)solid.nnode));
            for (size_t i = 0; i < body_node_count(&b); i++) {
                held[2 * i] = b.level[i / (size_t)plane.nnode];
                held[2 * i + 1] = (double)(i % (size_t)plane.nnode);
            }
            CHECK_OK(body_solid_values(&b, 2, held, there));
            for (int i = 0; i < solid.nnode; i++) {
                CHECK_WITHIN(there[2 * i], solid.xyz[3 * i + 2], 1e-14);
                CHECK_WITHIN(there[2 * i + 1], i % plane.nnode, 1e-10);
            }
            free(held);
            free(there);
            body_free(&b);
            mesh_free(&solid);
            mesh_free(&plane);
        }
    }
}

static void voids_are_left_out_and_ranks_have_their_part(void)
{
    const double layer[] = {0, 1, 2, 3};
    mesh plane = {0}, solid = {0};
    body b = {0};
    CHECK_OK(strip(5, 2, &plane));
    const int n = plane.block[0].nelem;
    int *matter = NULL;
    CHECK_OK(TAKE(matter, 3 * (size_t)n));
    for (int i = 0; i < 3 * n; i++) {
        matter[i] = i / n == 1 && i % n < 2 ? -1 : i % 2;
    }
    const body_spec spec = {.plane = &plane,
                            .materials = materials,
                            .order = 2,
                            .nlayer = 3,
                            .layer = layer,
                            .matter = matter};
    CHECK_OK(body_make(&spec, &b));
    CHECK_OK(body_solid(&b, &solid));
    CHECK(solid.block[0].nelem == 3 * n - 2 && solid.block[0].material[n] == matter[n + 2]);
    CHECK_NEAR(volume(&solid), (3 * n - 2) * 0.5, 1e-12);
    mesh_free(&solid);
    CHECK_OK(body_hold(&b, 2, 5));
    CHECK_OK(body_solid(&b, &solid));
    CHECK(solid.block[0].nelem == n - 2 && solid.nnode == 3 * plane.nnode);
    CHECK_NEAR(solid.xyz[2], 1, 1e-15);
    mesh_free(&solid);
    free(matter);
    body_free(&b);
    mesh_free(&plane);
}

int main(void)
{
    its_volume_is_the_bodys();
    voids_are_left_out_and_ranks_have_their_part();
    return test_failures != 0;
}
