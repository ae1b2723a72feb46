// Patch test: a skewed and bent mesh, layers of unequal heights, nodes moved at every level; the
// boundary follows a linear field, and so does all that is inside. Every shape, order and law, with
// and without the projected change of volume.
#include "tests/body_solve.h"
#include "tests/grid_mesh.h"

static const double H[3][3] = {{2e-3, -1e-3, 3e-3}, {4e-3, -3e-3, 1e-3}, {-2e-3, 5e-3, 1.5e-3}};

static void bent(const double *from, double *to)
{
    const double x = from[0], y = from[1];
    to[0] = x + 0.08 * sin(5 * y) + 0.1 * x * y;
    to[1] = 0.8 * y + 0.07 * cos(4 * x) - 0.05 * x * y;
}

static status wavy(const void *self, double s, double *xyz, mat3 *axes, double origin[3])
{
    const mesh *plane = (const mesh *)self;
    *axes = mat3_identity();
    memcpy(origin, (const double[3]){0, 0, s}, 3 * sizeof *origin);
    for (int i = 0; i < plane->nnode; i++) {
        const double *x = plane->xyz + 3 * (size_t)i;
        xyz[3 * i] = x[0] * (1 + 0.1 * sin(3 * s)) + 0.1 * s * s;
        xyz[3 * i + 1] = x[1] * (1 - 0.1 * s) + 0.05 * cos(2 * s) * x[0];
        xyz[3 * i + 2] = s + 0.05 * x[0] * x[1] * (1 + s);
    }
    return OK;
}

static void linear(const double *x, double *u)
{
    for (int d = 0; d < 3; d++) {
        u[d] = H[d][0] * x[0] + H[d][1] * x[1] + H[d][2] * x[2];
    }
}

static void hold_boundary(equations *s, const bool *wall)
{
    const body *b = s->body;
    const int n = b->plane->nnode;
    for (int i = 0; i < n * b->nlevel; i++) {
        double x[3], u[3];
        body_node(b, i % n, i / n, x);
        linear(x, u);
        for (int d = 0; d < 3 && (wall[i] || i < n || i >= n * (b->nlevel - 1)); d++) {
            hold(s, i % n, i / n, d, u[d]);
        }
    }
}

static double worst_inside(const equations *s)
{
    double worst = 0, size = 0;
    const int n = s->body->plane->nnode;
    for (int i = 0; i < n * s->body->nlevel; i++) {
        double x[3], u[3];
        body_node(s->body, i % n, i / n, x);
        linear(x, u);
        for (int d = 0; d < 3; d++) {
            worst = fmax(worst, fabs(s->f[3 * i + d] - u[d]));
            size = fmax(size, fabs(u[d]));
        }
    }
    return worst / size;
}

static double patch(const material *m, int order, bool triangles, bool mapped, bool mixed)
{
    const double layer[3] = {0, 0.3, 1};
    const face_part walls = {FACE_OUTSIDE, 0, INFINITY};
    const grid g = {2, 3, order, triangles, NULL, bent};
    mesh plane = {0};
    body b = {0};
    equations s = {0};
    bool *wall = NULL;
    grid_make(&g, &plane);
    body_spec spec = {.plane = &plane,
                      .materials = m,
                      .order = 1 + order % 3,
                      .nlayer = 2,
                      .layer = layer,
                      .mixed = mixed};
    if (mapped) {
        spec.shape = (body_shape){.self = &plane, .place = wavy};
    }
    CHECK_OK(body_make(&spec, &b));
    equations_make(&b, &s);
    assemble(&s);
    CHECK_OK(TAKE(wall, body_node_count(&b)));
    CHECK_OK(face_nodes(&b, &walls, 0, b.nlevel, wall));
    hold_boundary(&s, wall);
    solve(&s);
    const double worst = worst_inside(&s);
    free(wall);
    equations_free(&s);
    body_free(&b);
    mesh_free(&plane);
    return worst;
}

int main(void)
{
    against(BY_CLOSED_FORM, "linear fields");
    material m[3] = {{.E = 1, .nu = 0.3},
                     {.E = 1, .nu = 0.4999},
                     {.E1 = 10,
                      .E2 = 1,
                      .E3 = 2,
                      .G12 = 0.7,
                      .G13 = 0.5,
                      .G23 = 0.4,
                      .nu12 = 0.3,
                      .nu13 = 0.25,
                      .nu23 = 0.2,
                      .fibre_angle = 0.4,
                      .plane_angle = 0.3}};
    static const char *const names[3] = {"nu = 0.3", "nu = 0.4999", "orthotropic"};
    for (int k = 0; k < 3; k++) {
        CHECK_OK(material_bind(&m[k]));
        for (int how = 0; how < 8; how++) {
            const bool triangles = how & 1, mapped = how & 2, mixed = how & 4;
            printf("%s, %s%s%s:", names[k], triangles ? "prisms" : "hexahedra",
                   mapped ? ", mapped" : "", mixed ? ", projected" : "");
            for (int order = 1; order <= ELEMENT_MAX_ORDER; order++) {
                const double worst = patch(&m[k], order, triangles, mapped, mixed);
                printf(" %.0e", worst);
                // rounding times the condition, which grows as 1 / (1 - 2 nu)
                CHECK_WITHIN(worst, 0, k == 1 ? 1e-10 : 1e-12);
            }
            printf("\n");
        }
    }
    return test_failures != 0;
}
