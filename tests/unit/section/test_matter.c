// tests/unit/section/test_matter.c
#include "section/matter.h"

#include "tests/verify/section/hand_meshes.h"

static void place_in_square(double u, double v, double *xyz)
{
    xyz[0] = 1 + u;
    xyz[1] = 2 + v;
    xyz[2] = 0;
}

static int by_column(double u, double v)
{
    (void)v;
    return u > 0.5;
}

static const lattice four = {
    .order = 1, .n0 = 2, .n1 = 2, .place = place_in_square, .material = by_column};

static material fibre(double angle)
{
    material m = {.name = "fibre",
                  .E1 = 10e6,
                  .E2 = 2e6,
                  .E3 = 1e6,
                  .G12 = 0.5e6,
                  .G13 = 0.4e6,
                  .G23 = 0.3e6,
                  .nu12 = 0.3,
                  .nu13 = 0.3,
                  .nu23 = 0.3,
                  .fibre_angle = angle};
    CHECK_OK(material_bind(&m));
    return m;
}

static void equal_elements_share_a_law(void)
{
    mesh m = lattice_mesh(&four);
    matter all = {0};
    const material two[2] = {{.E = 1e6, .nu = 0.3}, fibre(0)};
    CHECK_OK(matter_make(&m, two, &all));
    CHECK(all.nlaw == 2 && !all.coupled);
    CHECK(all.of[0][0] == all.of[0][2] && all.of[0][0] != all.of[0][1]);
    matter_free(&all);

    CHECK_OK(mesh_take_frames(&m, 2));
    m.frame[0] = material_frame_make(0.3, 0);
    m.frame[1] = material_frame_make(0.3, 0.2);
    m.block[0].frame[0] = 0; // of the isotropic one: nothing to turn
    m.block[0].frame[1] = 0;
    m.block[0].frame[3] = 1;
    CHECK_OK(matter_make(&m, two, &all));
    CHECK(all.nlaw == 3 && all.coupled);
    CHECK(all.of[0][0] == all.of[0][2]);
    matter_free(&all);
    mesh_free(&m);
}

// a fibre along the rod, or across it in the section, couples nothing; one that leans does
static void leaning_fibres_couple(void)
{
    static const double angle[4] = {0, 1.5707963267948966, 0.3, 1e-9};
    mesh m = lattice_mesh(&four);
    for (int k = 0; k < 4; k++) {
        const material two[2] = {fibre(angle[k]), fibre(0)};
        matter all = {0};
        CHECK_OK(matter_make(&m, two, &all));
        CHECK(all.coupled == (k > 1));
        matter_free(&all);
    }
    mesh_free(&m);
}

static void polar_frames_turn_with_the_place(void)
{
    mesh m = lattice_mesh(&four);
    plane p = {0};
    plane_element e;
    matter all = {0};
    matter_element at;
    const material two[2] = {fibre(0), fibre(0)};
    CHECK_OK(mesh_take_frames(&m, 1));
    m.frame[0] = material_frame_make(0, 0.4);
    m.frame[0].polar = true;
    m.frame[0].centre[0] = 1;
    m.block[0].frame[0] = 0;
    CHECK_OK(plane_make(&m, 3, &p));
    CHECK_OK(matter_make(&m, two, &all));
    CHECK_OK(plane_element_at(&p, 0, 0, &e));
    CHECK_OK(matter_at(&all, &p, &e, &at));
    for (int q = 0; q < e.npoint; q++) {
        const double x = p.centre[0] + p.length * e.x[q], y = p.centre[1] + p.length * e.y[q];
        // along the circle about (1, 0)
        const material_frame f = material_frame_make(atan2(y, x - 1) + pi / 2, 0.4);
        const mat6 wanted = material_stiffness_in(&two[0], &f, 0, 0);
        const mat6 *Q = matter_stiffness(&all, &p, &e, q, &at);
        for (int i = 0; i < 36; i++) {
            CHECK_WITHIN(Q->a[i / 6][i % 6] * all.modulus, wanted.a[i / 6][i % 6], 1e-8);
        }
    }
    matter_free(&all);
    plane_free(&p);
    mesh_free(&m);
}

static double rising(const void *expression, double x, double y, double s)
{
    (void)s;
    return *(const double *)expression * x * y;
}

static void grades_weigh_the_points_and_must_be_positive(void)
{
    mesh m = lattice_mesh(&four);
    plane p = {0};
    plane_element e;
    matter all = {0};
    matter_element at;
    double slope = 2e6;
    const material two[2] = {{.name = "graded",
                              .E = 1e6,
                              .nu = 0.3,
                              .modulus = {.at = rising, .expression = &slope, .across = true}},
                             {.name = "plain", .E = 1e6, .nu = 0.3}};
    CHECK_OK(plane_make(&m, 3, &p));
    CHECK_OK(matter_make(&m, two, &all));
    CHECK_OK(plane_element_at(&p, 0, 0, &e));
    CHECK_OK(matter_at(&all, &p, &e, &at));
    for (int q = 0; q < e.npoint; q++) {
        const double x = p.centre[0] + p.length * e.x[q], y = p.centre[1] + p.length * e.y[q];
        CHECK_NEAR(at.weight[q], 2 * x * y * e.dA[q], 1e-14);
    }
    slope = -1;
    CHECK(matter_at(&all, &p, &e, &at) == ERR_INPUT);
    status_clear();
    slope = NAN;
    CHECK(matter_at(&all, &p, &e, &at) == ERR_INPUT);
    status_clear();
    CHECK_OK(plane_element_at(&p, 0, 1, &e));
    CHECK_OK(matter_at(&all, &p, &e, &at));
    CHECK(at.weight[0] == e.dA[0]);
    matter_free(&all);
    plane_free(&p);
    mesh_free(&m);
}

int main(void)
{
    equal_elements_share_a_law();
    leaning_fibres_couple();
    polar_frames_turn_with_the_place();
    grades_weigh_the_points_and_must_be_positive();
    return test_failures != 0;
}
