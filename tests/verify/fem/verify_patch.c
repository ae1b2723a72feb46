// tests/verify/fem/verify_patch.c
// Exact fields on a bad mesh: skewed quads and triangles of two materials with one Poisson's
// ratio, layers of heights 1 to 40, every order. Free base, E-proportional traction: uniform strain
// for a force at the stiffness centre; a moment's strain is linear in x and y, its displacement
// quadratic, and exact from order 2 on.
#include "tests/verify/fem/bad_mesh.h"
#include "tests/verify/fem/polar_mesh.h"

static double worst_displacement(const column_model *m, strain e, const double *u)
{
    const int n = m->plane.nnode, nlevel = m->nlevel;
    double size = 0, worst = 0, d[3],
           shift[3] = {0}; // motion in the plane: two of node 0, a turn by node n - 1
    const double *xyz = m->plane.xyz, *far = xyz + 3 * (n - 1);
    for (int pass = 0; pass < 2; pass++) {
        for (int i = 0; i < n * nlevel; i++) {
            const double x = xyz[3 * (i % n)], y = xyz[3 * (i % n) + 1];
            exact_displacement(e, x, y, m->level[i / n], d);
            for (int k = 0; k < 3; k++) {
                size = fmax(size, fabs(d[k]));
                d[k] = u[3 * i + k] - d[k];
            }
            if (pass == 0 && i == 0) {
                shift[0] = d[0];
                shift[1] = d[1];
            }
            if (pass == 0 && i == n - 1) {
                const double dx = far[0] - xyz[0], dy = far[1] - xyz[1];
                shift[2] = (dx * (d[1] - shift[1]) - dy * (d[0] - shift[0])) / (dx * dx + dy * dy);
            }
            d[0] -= shift[0] - shift[2] * (y - xyz[1]);
            d[1] -= shift[1] + shift[2] * (x - xyz[0]);
            for (int k = 0; pass == 1 && k < 3; k++) {
                worst = fmax(worst, fabs(d[k]));
            }
        }
    }
    return worst / size;
}

// the wrench (n_z, m_x, m_y) of the strain, applied at the origin
static void check_strain(column_model *m, strain e, const double *s)
{
    const double none[1][2] = {{0, 0}};
    const segment_load load = {.name = "strain",
                               .force = {0, 0, e.a * s[0] + e.b * s[1] + e.c * s[2]},
                               .moment = {e.a * s[2] + e.b * s[4] + e.c * s[5],
                                          -(e.a * s[1] + e.b * s[3] + e.c * s[4]), 0}};
    segment_result r = {0};
    CHECK_OK(model_solve(m, 1, &load, none, 1, &r));
    if (!r.load) {
        return;
    }
    const double L = m->level[m->nlevel - 1],
                 worst = worst_displacement(m, e, r.load[0].displacement);
    const double centre[2] = {s[1] / s[0], s[2] / s[0]};
    printf("order %d, eps = %g %+g x %+g y: displacements to %.1e\n", m->plane.order, e.a, e.b, e.c,
           worst);
    // rounding times the condition of a mesh with layers of 1 to 40 and angles of 10 degrees
    CHECK_WITHIN(worst, 0, e.b == 0 ? 1e-10 : 1e-9);
    CHECK_NEAR(r.load[0].shortening, -L * (e.a + e.b * centre[0] + e.c * centre[1]), 1e-10);
    const double turn = fabs(e.b) + fabs(e.c), flat = 1e-10 * (turn + fabs(e.a) / L);
    CHECK_WITHIN(r.load[0].mid_curvature[0], e.c, flat);
    CHECK_WITHIN(r.load[0].mid_curvature[1], -e.b, flat);
    CHECK_WITHIN(r.load[0].tip_rotation[1], -e.b * L, flat * L);
    CHECK_NEAR(r.stiffness_centre[0], centre[0], 1e-9);
    CHECK_NEAR(r.stiffness_centre[1], centre[1], 1e-9);
    const double work =
        (load.force[2] * (e.a) + load.moment[0] * e.c - load.moment[1] * e.b) * L / 2;
    CHECK_NEAR(r.load[0].strain_energy, work, 1e-10);
    segment_result_free(&r);
}

int main(void)
{
    against(BY_CLOSED_FORM, "uniform and linear strains on bad meshes");
    double s[6] = {0};
    stiffness_integrals(s);
    // a uniform strain is a force at the stiffness centre alone
    const strain uniform = {.a = -0.02}, bent = {.a = 0.01, .b = 3, .c = -5};
    for (int order = 1; order <= ELEMENT_MAX_ORDER; order++) {
        column_model m = {0};
        bad_mesh(order, &m.plane);
        CHECK_OK(mesh_check(&m.plane));
        CHECK_OK(extrude_plainly(5, 40, 7e-3, &m));
        m.source.materials = bad_materials;
        m.c.base = BASE_FREE_TO_CONTRACT;
        m.c.tip = TIP_E_PROPORTIONAL;
        check_strain(&m, uniform, s);
        if (order > 1) {
            check_strain(&m, bent, s);
        }
        column_model_free(&m);
    }
    return test_failures != 0;
}
