// tests/unit/section/test_mass_along.c
// Mass per length and its centre at every station, by whatever way its law came about, against
// closed forms of an annulus with a sector.
#include "section/section.h"
#include "tests/test.h"

#include <math.h>

static const double pi = 3.14159265358979323846, length = 0.12;
static const double outer = 4e-3, inner = 3.2e-3;

static const material two[2] = {{.E = 0.66e6, .nu = 0.3, .density = 1100},
                                {.E = 15.93e6, .nu = 0.3, .density = 1250}};

// rounding of sums over some hundred elements, and of curved elements' areas at order 4
static const double closed_rounding = 1e-13, mesh_error = 1e-8;
// what stations are chosen for, and the tail behind it
static const double interpolation_error = 3e-10;

static double half_turn(const void *unused, double s)
{
    (void)unused;
    return pi * s / length;
}

static double narrowing(const void *unused, double s)
{
    (void)unused;
    return pi / 4 - pi / 8 * s / length;
}

static double growing(const void *unused, double s)
{
    (void)unused;
    return 1 + s / length;
}

static section_case sector_case(int model, shape_spec shapes[2])
{
    const ring_spec ring = {.outer_radius = field_constant(outer),
                            .inner_radius = field_constant(inner)};
    shapes[0] = (shape_spec){.annulus = ring, .material_index = 0};
    shapes[0].annulus.at = (mark){1, 1};
    shapes[1] = (shape_spec){.sector = ring, .material_index = 1};
    shapes[1].sector.at = (mark){2, 1};
    shapes[1].sector.mid_angle = field_constant(0.7);
    shapes[1].sector.width = field_constant(pi / 4);
    section_case c = section_case_default();
    c.nmaterial = 2;
    c.model = model;
    c.shapes = (key_list){.count = 2, .items = shapes};
    return c;
}

// The annulus' mass has its centre in the middle; the sector adds the difference of the densities.
static double exact_mass(const material *m, double width, double mid, double scale,
                         double centre[2])
{
    const double jump = m[1].density - m[0].density;
    const double half_square = (outer * outer - inner * inner) / 2 * scale * scale;
    const double third_cube = (pow(outer, 3) - pow(inner, 3)) / 3 * pow(scale, 3);
    const double mass = half_square * (m[0].density * 2 * pi + jump * width);
    const double r = third_cube * jump * 2 * sin(width / 2) / mass;
    centre[0] = r * cos(mid);
    centre[1] = r * sin(mid);
    return mass;
}

static void check_mass(double mass, const double centre[2], double exact, const double wanted[2],
                       double tolerance)
{
    CHECK(fabs(mass - exact) <= tolerance * exact);
    CHECK(hypot(centre[0] - wanted[0], centre[1] - wanted[1]) <= tolerance * outer);
}

static void check_law(const beam_law *law, double exact, const double wanted[2], double tolerance)
{
    check_mass(law->mass, law->mass_centre, exact, wanted, tolerance);
}

static void one_section_in_both_models(void)
{
    shape_spec shapes[2];
    beam_law law = {0};
    double centre[2];
    section_case c = sector_case(MODEL_CLASSICAL, shapes);
    const double exact = exact_mass(two, pi / 4, 0.7, 1, centre);
    CHECK_OK(section_solve(&c, two, 0, length, &law));
    check_law(&law, exact, centre, closed_rounding);

    c = sector_case(MODEL_FULL, shapes);
    c.mesh.order = 4;
    CHECK_OK(section_solve(&c, two, 0, length, &law));
    check_law(&law, exact, centre, mesh_error);
    // in the frame that turns about the origin
    c.turn = (field){.at = half_turn};
    CHECK_OK(section_solve(&c, two, 0, length, &law));
    check_law(&law, exact, centre, mesh_error);
}

static void off_the_origin_on_a_mesh(void)
{
    const double w = 4e-3, h = 1e-3, at[2] = {3e-3, -2e-3}, rho = 1100;
    shape_spec shape = {.rectangle = {.at = {1, 1},
                                      .width = field_constant(w),
                                      .height = field_constant(h),
                                      .centre = {field_constant(at[0]), field_constant(at[1])}}};
    for (int model = MODEL_FULL; model <= MODEL_CLASSICAL; model++) {
        section_case c = section_case_default();
        beam_law law = {0};
        c.model = model;
        c.nmaterial = 1;
        c.shapes = (key_list){.count = 1, .items = &shape};
        CHECK_OK(section_solve(&c, two, 0, length, &law));
        check_law(&law, rho * w * h, at, closed_rounding);
    }
}

static double exact_at(const section_case *c, const material *m, double s, double centre[2])
{
    const shape_spec *shapes = c->shapes.items;
    const ring_spec *sector = &shapes[1].sector;
    const double scale = field_varies(&c->scale) ? field_at(&c->scale, s) : 1;
    const double mid = field_at(&sector->mid_angle, s) + field_at(&c->turn, s);
    return exact_mass(m, field_at(&sector->width, s), mid, scale, centre);
}

static void check_along(const section_case *c, const material *m, double tolerance)
{
    section_result r = {0};
    CHECK_OK(section_along(c, m, length, &r));
    CHECK(law_along_has_mass(&r.along));
    for (int i = 0; i <= 7; i++) {
        double centre[2], wanted[2];
        const double exact = exact_at(c, m, length * i / 7, wanted);
        const double mass = law_along_mass(&r.along, length * i / 7, centre);
        check_mass(mass, centre, exact, wanted, tolerance);
    }
    for (int i = 0; i < r.nstation; i++) {
        const section_station *here = &r.station[i];
        double wanted[2];
        const double exact = exact_at(c, m, here->s, wanted);
        check_mass(here->law.mass, here->law.mass_centre, exact, wanted, tolerance);
    }
    section_result_free(&r);
}

static void patterns_that_turn(void)
{
    for (int model = MODEL_FULL; model <= MODEL_CLASSICAL; model++) {
        shape_spec shapes[2];
        section_case c = sector_case(model, shapes);
        c.mesh.order = 4;
        shapes[1].sector.mid_angle = (field){.at = half_turn};
        check_along(&c, two, mesh_error);
        c.turn = (field){.at = half_turn};
        check_along(&c, two, mesh_error);
    }
}

static void tapered_rods(void)
{
    for (int model = MODEL_FULL; model <= MODEL_CLASSICAL; model++) {
        shape_spec shapes[2];
        section_case c = sector_case(model, shapes);
        c.mesh.order = 4;
        c.scale = (field){.at = growing};
        check_along(&c, two, mesh_error);
    }
}

static void a_sector_that_narrows(void)
{
    shape_spec shapes[2];
    section_case c = sector_case(MODEL_CLASSICAL, shapes);
    shapes[1].sector.width = (field){.at = narrowing};
    check_along(&c, two, interpolation_error);
}

// K is the same everywhere, so that only the mass asks for stations
static void densities_alone_vary(void)
{
    const material equal[2] = {{.E = 1e6, .nu = 0.3, .density = 1000},
                               {.E = 1e6, .nu = 0.3, .density = 9000}};
    shape_spec shapes[2];
    section_case c = sector_case(MODEL_CLASSICAL, shapes);
    shapes[1].sector.width = (field){.at = narrowing};
    check_along(&c, equal, interpolation_error);
}

// one density missing: no mass at all, and the law says so
static void unknown_densities(void)
{
    shape_spec shapes[2];
    const material half[2] = {{.E = 0.66e6, .nu = 0.3}, {.E = 15.93e6, .nu = 0.3, .density = 1250}};
    for (int model = MODEL_FULL; model <= MODEL_CLASSICAL; model++) {
        section_case c = sector_case(model, shapes);
        section_result r = {0};
        CHECK_OK(section_along(&c, half, length, &r));
        CHECK(!law_along_has_mass(&r.along));
        CHECK(r.along.law[0].mass == 0 && r.along.law[0].mass_centre[0] == 0);
        section_result_free(&r);
    }
}

// an earlier run's law comes with its mass, and only where the densities are the same
static void recalled(void)
{
    shape_spec shapes[2];
    section_case c = sector_case(MODEL_FULL, shapes);
    section_result first = {0}, second = {0};
    const section_known nothing = {0};
    material other[2] = {two[0], two[1]};
    c.known = &nothing;
    CHECK_OK(section_along(&c, two, length, &first));
    c.known = &first.solved;
    CHECK_OK(section_along(&c, two, length, &second));
    CHECK(second.effort.nstored == 1);
    CHECK(second.along.law[0].mass == first.along.law[0].mass);
    CHECK(second.along.law[0].mass_centre[0] == first.along.law[0].mass_centre[0]);
    section_result_free(&second);
    other[0].density = 1101;
    CHECK_OK(section_along(&c, other, length, &second));
    CHECK(second.effort.nstored == 0 && second.along.law[0].mass > first.along.law[0].mass);
    section_result_free(&first);
    section_result_free(&second);
}

int main(void)
{
    one_section_in_both_models();
    off_the_origin_on_a_mesh();
    patterns_that_turn();
    tapered_rods();
    a_sector_that_narrows();
    densities_alone_vary();
    unknown_densities();
    recalled();
    return test_failures != 0;
}
