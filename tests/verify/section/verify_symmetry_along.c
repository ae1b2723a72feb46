// tests/verify/section/verify_symmetry_along.c
// A section that declares its axis of symmetry hands it on to the law along the rod: the frame of
// the stiffness centre turns with the pattern, exactly, also where the two bending moments cross.
#include "section/section.h"
#include "tests/test.h"

static const double pi = 3.14159265358979323846, length = 0.12;

static const material two[2] = {{.name = "soft", .E = 0.66e6, .nu = 0.45},
                                {.name = "stiff", .E = 15.93e6, .nu = 0.45}};

static double half_turn(const void *expression, double s)
{
    (void)expression;
    return pi * s / length;
}

static double narrowing(const void *expression, double s)
{
    (void)expression;
    return pi / 2 - pi / 4 * s / length;
}

// annulus and stiff sector, the moments crossing where the sector is 0.443 pi wide; a second
// sector that spoils the symmetry
static void set_shapes(shape_spec shapes[3])
{
    const ring_spec ring = {
        .at = {1, 1}, .outer_radius = field_constant(4e-3), .inner_radius = field_constant(3.2e-3)};
    shapes[0] = (shape_spec){.annulus = ring, .material_index = 0};
    shapes[1] = (shape_spec){.sector = ring, .material_index = 1};
    shapes[1].sector.mid_angle.at = half_turn;
    shapes[1].sector.width.at = narrowing;
    shapes[2] = (shape_spec){.sector = ring, .material_index = 1};
    shapes[2].sector.mid_angle = field_constant(4.5);
    shapes[2].sector.width = field_constant(0.2);
}

static void frame_is_the_declared_axis(int model)
{
    shape_spec shapes[3];
    set_shapes(shapes);
    section_case c = section_case_default();
    c.model = model;
    c.shapes = (key_list){.count = 2, .items = shapes};
    section_result r = {0};
    CHECK_OK(section_along(&c, two, length, &r));
    CHECK(r.along.symmetric);
    const beam_centres *base = &r.station[0].centres, *tip = &r.station[r.nstation - 1].centres;
    CHECK_ABOVE(base->EI[0], base->EI[1]);
    CHECK_BELOW(tip->EI[0], tip->EI[1]); // the test can tell
    for (int i = 0; i <= 4000; i++) {
        const double s = length * i / 4000;
        centre_frame f;
        law_along_centre_frame(&r.along, s, half_turn(NULL, s), &f);
        CHECK_WITHIN(f.phi, half_turn(NULL, s), 1e-13);
        CHECK_NEAR(f.dphi, pi / length, 1e-11);
    }
    section_result_free(&r);
}

static void without_symmetry_nothing_is_declared(void)
{
    shape_spec shapes[3];
    set_shapes(shapes);
    section_case c = section_case_default();
    c.model = MODEL_CLASSICAL;
    shapes[1].sector.mid_angle = field_constant(1);
    c.shapes = (key_list){.count = 3, .items = shapes};
    section_result r = {0};
    CHECK_OK(section_along(&c, two, length, &r));
    CHECK(!r.along.symmetric);
    section_result_free(&r);
}

int main(void)
{
    against(BY_SYMMETRY, "the declared axis of symmetry");
    frame_is_the_declared_axis(MODEL_CLASSICAL);
    frame_is_the_declared_axis(MODEL_FULL);
    without_symmetry_nothing_is_declared();
    return test_failures != 0;
}
