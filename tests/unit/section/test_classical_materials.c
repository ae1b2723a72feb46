// tests/unit/section/test_classical_materials.c
// The paper's model with moduli that vary or have directions, against closed forms.
#include "section/section.h"
#include "tests/shapes.h"
#include "tests/test.h"

// sums over straight elements
static const double EXACT = 1e-12;
// the area of circles as elements of order 4 draw them, 1e-11 off
static const double CURVED = 1e-10;

static double linear_in_x(const void *unused, double x, double y, double s)
{
    (void)unused, (void)y;
    return 2e6 + 3e8 * x + 1e6 * s;
}

static material graded_in_x(void)
{
    material m = {.name = "graded",
                  .nu = 0.25,
                  .modulus = {.at = linear_in_x, .across = true, .along = true}};
    CHECK_OK(material_bind(&m));
    return m;
}

static material glass(double plane_angle, double fibre_angle)
{
    material m = {.name = "glass",
                  .E1 = 41e9,
                  .E2 = 10.4e9,
                  .E3 = 9.1e9,
                  .G12 = 4.3e9,
                  .G13 = 3.1e9,
                  .G23 = 3.5e9,
                  .nu12 = 0.28,
                  .nu13 = 0.31,
                  .nu23 = 0.45,
                  .plane_angle = plane_angle,
                  .fibre_angle = fibre_angle};
    CHECK_OK(material_bind(&m));
    return m;
}

static beam_law law_of(const shape_spec *shape, const material *m, int kind)
{
    mesh made = {0};
    beam_law law = {0};
    CHECK_OK(mesh_of(1, shape, kind, 4, 0, &made));
    CHECK_OK(section_classical_mesh(&made, m, &law));
    mesh_free(&made);
    return law;
}

// E = a + b x over the rectangle |x| < w / 2, |y| < h / 2: every integral by hand
static void a_modulus_that_grows_across_a_bar_shifts_its_centre(void)
{
    const double w = 0.01, h = 0.004, A = w * h, Iyy = A * w * w / 12, Ixx = A * h * h / 12;
    const material m = material_at((const material[]){graded_in_x()}, 0.5);
    const double a = 2.5e6, b = 3e8;
    const shape_spec bar = a_rectangle(w, h, 0, 0, 0, 0);
    const beam_law law = law_of(&bar, &m, MESH_MAPPED);
    beam_centres centres = {0};
    CHECK_OK(beam_law_centres(&law, &centres));
    const double x = b * Iyy / (a * A); // int E x / int E
    CHECK_NEAR(law.K.a[NZ][NZ], a * A, EXACT);
    CHECK_NEAR(centres.stiffness_centre[0], x, EXACT);
    CHECK_NEAR(law.K.a[MX][MX], a * Ixx, EXACT);
    CHECK_NEAR(law.K.a[MY][MY], a * Iyy, EXACT); // about the origin: int E x^2, odd part gone
    CHECK_NEAR(centres.EI_centre[1], a * Iyy - x * x * a * A, EXACT);
    CHECK_NEAR(law.K.a[NX][NX], a * A / 2.5, EXACT);
}

static void a_modulus_that_becomes_negative_is_refused_where_it_does(void)
{
    const material m = graded_in_x(); // 2e6 + 3e8 x < 0 for x < -6.7 mm
    const shape_spec bar = a_rectangle(0.02, 0.004, 0, 0, 0, 0);
    mesh made = {0};
    beam_law law = {0};
    CHECK_OK(mesh_of(1, &bar, MESH_MAPPED, 2, 0, &made));
    CHECK(section_classical_mesh(&made, &m, &law) == ERR_INPUT);
    CHECK(strstr(status_message(), "material 'graded': E = -") &&
          strstr(status_message(), "it must be more than 0"));
    status_clear();
    mesh_free(&made);
}

static void what_varies_along_the_rod_alone_freezes_to_a_number(void)
{
    material m = {.nu = 0.25, .modulus = {.at = linear_in_x, .along = true}};
    CHECK_OK(material_bind(&m));
    const material later = material_at(&m, 2), never = material_at(&m, -3);
    CHECK(!material_is_graded(&later) && !material_varies(&later));
    CHECK_NEAR(later.E, 4e6, EXACT);
    double grade = 0; // 2e6 - 3e6
    CHECK(material_is_graded(&never) && material_check_grade(&never, 0, 0, &grade) == ERR_INPUT);
    status_clear();
}

// fibres off the axis: the laminate's modulus for stretch and bending
static void off_axis_fibres_count_by_their_compliance(void)
{
    const double w = 0.01, h = 0.004, c = cos(0.7), s = sin(0.7);
    const material m = glass(0, 0.7);
    const double E = 1 / (c * c * c * c / m.E1 + (1 / m.G12 - 2 * m.nu12 / m.E1) * s * s * c * c +
                          s * s * s * s / m.E2);
    const shape_spec bar = a_rectangle(w, h, 0, 0, 0, 0);
    const beam_law law = law_of(&bar, &m, MESH_MAPPED);
    CHECK_NEAR(law.K.a[NZ][NZ], E * w * h, EXACT);
    CHECK_NEAR(law.K.a[MX][MX], E * w * h * h * h / 12, EXACT);
    // the plane of 1 and 3 turns as a vector does: 1 / G_zy = c^2 / G13 + s^2 / G23
    CHECK_NEAR(law.K.a[NY][NY], w * h / (c * c / m.G13 + s * s / m.G23), EXACT);
}

// the section turned as a whole, shape and plane of the fibres: the same law in turned axes
static void a_turned_section_has_the_turned_law(void)
{
    const double angle = 0.4;
    const material m = glass(0.3, 0), more = glass(0.3 + angle, 0);
    const shape_spec bar = a_rectangle(0.01, 0.004, 0.2, 0, 0, 0);
    shape_spec turned = a_rectangle(0.01, 0.004, 0.2 + angle, 0, 0, 0), own = turned;
    const beam_law a = law_of(&bar, &m, MESH_MAPPED), b = law_of(&turned, &more, MESH_MAPPED);
    CHECK(fabs(a.K.a[NX][NY]) > 1e-3 * a.K.a[NX][NX]); // there is something to turn
    CHECK(mat6_relative_error(beam_law_move(b.K, 0, 0, angle), a.K) < EXACT);
    // and by the shape's own axes
    own.axes = SHAPE_AXES_TANGENT;
    const material straight = glass(0, 0);
    shape_spec first = bar;
    first.axes = SHAPE_AXES_TANGENT;
    const beam_law p = law_of(&first, &straight, MESH_MAPPED);
    const beam_law q = law_of(&own, &straight, MESH_MAPPED);
    CHECK(mat6_relative_error(beam_law_move(q.K, 0, 0, angle), p.K) < EXACT);
}

// twist of a ring shears along the circle alone: G12 there, whatever the radial one is
static void a_wound_ring_twists_with_the_modulus_along_its_circle(void)
{
    const double ro = 4e-3, ri = 3e-3, A = PI * (ro * ro - ri * ri);
    const double J = PI / 2 * (pow(ro, 4) - pow(ri, 4));
    const material m = glass(0, 0);
    shape_spec ring = an_annulus(ro, ri, 0);
    ring.axes = SHAPE_AXES_TANGENT;
    const beam_law law = law_of(&ring, &m, MESH_MAPPED);
    CHECK_NEAR(law.K.a[MZ][MZ], m.G12 * J, CURVED);
    CHECK_NEAR(law.K.a[NX][NX], (m.G12 + m.G13) / 2 * A, CURVED);
    CHECK_NEAR(law.K.a[NZ][NZ], m.E1 * A, CURVED);
}

static void closed_forms_leave_directed_and_graded_materials_alone(void)
{
    const material materials[] = {{.E = 1e6, .nu = 0.3}, glass(0, 0), graded_in_x()};
    for (int i = 0; i < 3; i++) {
        outline ring = {.kind = KIND_ANNULUS, .outer = 2, .inner = 1, .material = i};
        const section_outline o = {.count = 1, .items = &ring, .size = 2};
        beam_law law = {0};
        bool done = false;
        CHECK_OK(section_classical_closed(&o, materials, &law, &done));
        CHECK(done == (i == 0));
    }
}

int main(void)
{
    a_modulus_that_grows_across_a_bar_shifts_its_centre();
    a_modulus_that_becomes_negative_is_refused_where_it_does();
    what_varies_along_the_rod_alone_freezes_to_a_number();
    off_axis_fibres_count_by_their_compliance();
    a_turned_section_has_the_turned_law();
    a_wound_ring_twists_with_the_modulus_along_its_circle();
    closed_forms_leave_directed_and_graded_materials_alone();
    return test_failures != 0;
}
