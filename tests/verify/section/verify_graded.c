// tests/verify/section/verify_graded.c
// What small elements at corners buy: figures that meshes of equal elements reach late or never.
// The times that belong to them are those of bench/bench_section.c and bench/bench_torsion.c.
#include "section/section.h"
#include "tests/shapes.h"
#include "tests/test.h"

static const mesh_options finest = {.order = 4, .finer = 2.8, .layers = 1};
static const mesh_options equal = {.order = 4, .size = 0.125e-3};

static beam_law law_on(int n, const shape_spec *shapes, const material *materials,
                       const mesh_options *options)
{
    section_outline o = {0};
    mesh m = {0};
    beam_law law = {0};
    CHECK_OK(shapes_at((shape_list){.count = n, .items = shapes}, 0, &o));
    CHECK_OK(section_mesh_make(&o, options, &m));
    CHECK_OK(section_full_mesh(&m, materials, &law, NULL));
    mesh_free(&m);
    section_outline_free(&o);
    return law;
}

static double torsion_on(const shape_spec *shape, const material *one, const mesh_options *options)
{
    const beam_law law = law_on(1, shape, one, options);
    beam_centres c = {0};
    CHECK_OK(beam_law_centres(&law, &c));
    return c.GJ;
}

// Saint-Venant's series, 4 mm x 1 mm, E = 1 MPa, nu = 0.3
static void a_rectangle_is_good_to_eight_digits(void)
{
    const material one = {.name = "one", .E = 1e6, .nu = 0.3};
    const shape_spec shape = a_rectangle(4e-3, 1e-3, 0, 0, 0, 0);
    const double exact = 0.4320199358642487e-6;
    const double error = torsion_on(&shape, &one, &finest) / exact - 1;
    printf("rectangle: GJ %.1e off its series\n", error);
    CHECK_WITHIN(error, 0, 1e-8);
    CHECK_ABOVE(error, 0); // an energy from above
}

// 1.87017 +- 2e-5 N mm^2, extrapolated by others; equal elements are beyond that with five times
// the nodes
static void an_angle_is_within_its_digits(void)
{
    static const double corner[6][2] = {{0, 0},       {6e-3, 0},     {6e-3, 1e-3},
                                        {1e-3, 1e-3}, {1e-3, 10e-3}, {0, 10e-3}};
    const material one = {.name = "one", .E = 1e6, .nu = 0.3};
    const shape_spec shape = a_polygon(6, &corner[0][0], 0);
    const mesh_options chosen = {.order = 4};
    const double GJ = 1e6 * torsion_on(&shape, &one, &chosen);
    printf("angle: GJ %.6f, on equal elements %.6f\n", GJ, 1e6 * torsion_on(&shape, &one, &equal));
    CHECK_WITHIN(GJ, 1.87017, 2e-5);
}

static void the_prototype_is_good_to_eight_digits(void)
{
    const material two[2] = {{.name = "soft", .E = 0.66e6, .nu = 0.3},
                             {.name = "stiff", .E = 15.93e6, .nu = 0.3}};
    const shape_spec shapes[2] = {an_annulus(4e-3, 3.2e-3, 0),
                                  a_sector(4e-3, 3.2e-3, PI, PI / 8, 1)};
    const mesh_options chosen = {.order = 4}, finer = {.order = 4, .finer = 2, .layers = 2};
    const mesh_options reference = {.order = 4, .finer = 4, .layers = 3};
    const beam_law truth = law_on(2, shapes, two, &reference);
    const double first = mat6_relative_error(law_on(2, shapes, two, &chosen).K, truth.K);
    const double second = mat6_relative_error(law_on(2, shapes, two, &finer).K, truth.K);
    printf("prototype: K to %.1e on the chosen mesh, %.1e on a finer one\n", first, second);
    CHECK_BELOW(first, 1e-6);
    CHECK_BELOW(second, 1e-8);
}

int main(void)
{
    against(BY_CLOSED_FORM, "Saint-Venant's series of a rectangle");
    a_rectangle_is_good_to_eight_digits();
    against(BY_OTHER_CODE, "GJ of an angle, extrapolated by an independent code");
    an_angle_is_within_its_digits();
    against(BY_OTHER_CODE, "6x6 of an independent finite-element code, good to 1e-6");
    the_prototype_is_good_to_eight_digits();
    return test_failures != 0;
}
