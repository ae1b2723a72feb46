// tests/unit/fem/test_section_fit.c
#include "base/memory.h"
#include "fem/section_fit.h"
#include "tests/test.h"

// two squares of side 1 beside each other, [0,1] and [1,2] in x, the right one three times as stiff
static const material materials[2] = {{.E = 1, .nu = 0.3}, {.E = 3, .nu = 0.1}};

static void two_squares(mesh *m)
{
    const shape quad = SHAPE_QUAD;
    const int two = 2, conn[2][4] = {{0, 1, 3, 4}, {1, 2, 4, 5}};
    CHECK_OK(mesh_make(1, 6, 1, &quad, &two, m));
    for (int i = 0; i < 6; i++) {
        m->xyz[3 * i] = i % 3;
        m->xyz[3 * i + 1] = i / 3;
    }
    for (int i = 0; i < 8; i++) {
        m->block[0].conn[i] = conn[i / 4][i % 4];
        m->block[0].material[i / 4] = i / 4;
    }
}

static double rigid_component(const vec6 q, int direction, const double *x)
{
    const double u[3] = {q.a[0] - q.a[5] * x[1], q.a[1] + q.a[5] * x[0],
                         q.a[2] + q.a[3] * x[1] - q.a[4] * x[0]};
    return u[direction];
}

static void weight_and_centroid_are_those_of_the_integral(const section_fit *E,
                                                          const section_fit *area)
{
    CHECK_NEAR(E->weight, 4.0, 1e-14);
    CHECK_NEAR(E->centroid[0], (0.5 + 3 * 1.5) / 4, 1e-14);
    CHECK_NEAR(E->centroid[1], 0.5, 1e-14);
    CHECK_NEAR(area->weight, 2.0, 1e-14);
    CHECK_NEAR(area->centroid[0], 1.0, 1e-14);
}

static void a_rigid_motion_is_fitted_exactly(const mesh *plane, const section_fit *fit)
{
    const vec6 q = {{0.3, -0.7, 1.1, 0.5, -0.2, 0.9}};
    double u[18];
    for (int i = 0; i < 18; i++) {
        u[i] = rigid_component(q, i % 3, plane->xyz + 3 * (i / 3));
    }
    const vec6 found = section_fit_motion(fit, u);
    for (int i = 0; i < 6; i++) {
        CHECK_WITHIN(found.a[i], q.a[i], 1e-13);
    }
}

// summed over the nodes, force number j is the unit wrench j about the origin
static void resultants_are_unit_wrenches(const mesh *plane, const section_fit *fit)
{
    for (int j = 0; j < 6; j++) {
        double w[6] = {0};
        for (int i = 0; i < plane->nnode; i++) {
            const double *f = fit->force + 18 * j + 3 * i, *x = plane->xyz + 3 * i;
            const double part[6] = {f[0],        f[1],         f[2],
                                    x[1] * f[2], -x[0] * f[2], x[0] * f[1] - x[1] * f[0]};
            for (int k = 0; k < 6; k++) {
                w[k] += part[k];
            }
        }
        for (int k = 0; k < 6; k++) {
            CHECK_WITHIN(w[k], k == j ? 1.0 : 0.0, 1e-13);
        }
    }
}

// an E-weighted mean: of u_z = 1 on the right outer edge, 0 elsewhere, by hand: int E N = 3 / 2 of
// EA = 4
static void the_mean_is_weighted_by_E(const section_fit *fit)
{
    double u[18] = {0};
    u[3 * 2 + 2] = u[3 * 5 + 2] = 1;
    const vec6 q = section_fit_motion(fit, u);
    const double mean = q.a[2] + q.a[3] * fit->centroid[1] - q.a[4] * fit->centroid[0];
    CHECK_NEAR(mean, 1.5 / 4, 1e-13);
}

int main(void)
{
    mesh plane = {0};
    column c = {0};
    section_fit by_E = {0}, by_area = {0};
    const double level[] = {0, 1};
    two_squares(&plane);
    CHECK_OK(column_make(&plane, materials, 1, 2, level, &c));
    CHECK_OK(section_fit_make(&c, WEIGHT_E, &by_E));
    CHECK_OK(section_fit_make(&c, WEIGHT_ONE, &by_area));
    if (by_E.force && by_area.force) {
        weight_and_centroid_are_those_of_the_integral(&by_E, &by_area);
        a_rigid_motion_is_fitted_exactly(&plane, &by_E);
        a_rigid_motion_is_fitted_exactly(&plane, &by_area);
        resultants_are_unit_wrenches(&plane, &by_E);
        resultants_are_unit_wrenches(&plane, &by_area);
        the_mean_is_weighted_by_E(&by_E);
    }
    section_fit_free(&by_E);
    section_fit_free(&by_area);
    column_free(&c);
    mesh_free(&plane);
    return test_failures != 0;
}
