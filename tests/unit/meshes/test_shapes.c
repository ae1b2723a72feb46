// tests/unit/meshes/test_shapes.c
#include "base/material.h"
#include "tests/shapes.h"
#include "tests/test.h"

static status freeze(int n, const shape_spec *shapes, section_outline *o)
{
    return shapes_at((shape_list){.count = n, .items = shapes}, 0.5, o);
}

// the message must name the shape and what is wrong with it
static void check_refused(const shape_spec *shapes, int n, const char *who, const char *why)
{
    section_outline o = {0};
    CHECK(freeze(n, shapes, &o) == ERR_INPUT);
    int line = 0, column = 0;
    CHECK(strncmp(who, "shape", 5) != 0 || (status_place(&line, &column) && line == 1));
    CHECK(!strstr(status_message(), "at s ="));
    const bool told = strstr(status_message(), who) && strstr(status_message(), why);
    if (!told) {
        printf("message: %s, wanted: %s ... %s\n", status_message(), who, why);
    }
    CHECK(told);
    status_clear();
    CHECK(o.items == NULL);
}

static void bad_numbers_are_refused_with_the_shape(void)
{
    const shape_spec good = an_annulus(4e-3, 3e-3, 0);
    const struct {
        shape_spec shape;
        const char *who, *why;
    } bad[] = {
        {an_annulus(3e-3, 4e-3, 0), "shape 2 (annulus)", "inner_radius"},
        {an_annulus(3e-3, 3e-3, 0), "shape 2 (annulus)", "inner_radius"},
        {an_annulus(4e-3, -1e-3, 0), "shape 2 (annulus)", "inner_radius"},
        {an_annulus(NAN, 1e-3, 0), "shape 2 (annulus)", "outer_radius"},
        {a_sector(4e-3, 3e-3, 0, 0, 0), "shape 2 (sector)", "width"},
        {a_sector(4e-3, 3e-3, 0, 2 * PI, 0), "shape 2 (sector)", "width"},
        {a_sector(4e-3, 3e-3, INFINITY, 1, 0), "shape 2 (sector)", "mid_angle"},
        {a_disc(0, 0, 0, 0), "shape 2 (disc)", "radius"},
        {a_disc(1e-3, NAN, 0, 0), "shape 2 (disc)", "centre_x"},
        {a_disc(1e9, 0, 0, 0), "shape 2 (disc)", "reaches"},
        {a_rectangle(1e-3, -1e-3, 0, 0, 0, 0), "shape 2 (rectangle)", "height"},
        {a_rectangle(1e-3, 1e-3, NAN, 0, 0, 0), "shape 2 (rectangle)", "angle"},
    };
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        const shape_spec shapes[] = {good, bad[i].shape};
        check_refused(shapes, 2, bad[i].who, bad[i].why);
    }
    check_refused(&good, 0, "empty", "no shapes");
    const shape_spec cuts = a_disc(1e-3, 0, 0, -1);
    check_refused(&cuts, 1, "empty", "no shape has a material");
    shape_spec both = good;
    both.disc = cuts.disc;
    check_refused(&both, 1, "shape 1", "exactly one");
}

static double shrinking(const void *unused, double s)
{
    (void)unused;
    return 4e-3 - 8e-3 * s;
}

static void the_arclength_is_told_where_something_varies(void)
{
    section_outline o = {0};
    shape_spec ring = an_annulus(4e-3, 3e-3, 0);
    ring.annulus.outer_radius = (field){.at = shrinking};
    CHECK(freeze(1, &ring, &o) == ERR_INPUT);
    CHECK(strstr(status_message(), "at s = 500 mm") != NULL);
    status_clear();
}

static void bad_polygons_are_refused(void)
{
    const double bow[] = {0, 0, 1, 1, 1, 0, 0, 1};
    const double spike[] = {0, 0, 2, 0, 1, 0, 1, 1};
    const double touching[] = {0, 0, 2, 0, 2, 2, 1, 0, 0, 2};
    const double line[] = {0, 0, 1, 0};
    const double repeated[] = {0, 0, 1, 0, 1, 0, 1, 1};
    const double square[] = {0, 0, 4, 0, 4, 4, 0, 4};
    const double outside[] = {3, 3, 5, 3, 5, 5, 3, 5};
    const double inside[] = {1, 1, 2, 1, 2, 2, 1, 2};
    const double nan[] = {0, 0, 1, 0, NAN, 1};
    const shape_spec bad[] = {
        a_polygon(4, bow, 0),  a_polygon(4, spike, 0),    a_polygon(5, touching, 0),
        a_polygon(2, line, 0), a_polygon(4, repeated, 0), a_polygon(3, nan, 0),
    };
    const char *why[] = {"cross", "cross", "cross", "three corners", "cross", "finite"};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        check_refused(&bad[i], 1, "shape 1 (polygon", why[i]);
    }

    hole_spec holes[] = {{.points = {.nrow = 4, .ncol = 2, .a = (double *)(size_t)outside}},
                         {.points = {.nrow = 4, .ncol = 2, .a = (double *)(size_t)inside}}};
    shape_spec with_hole = a_polygon(4, square, 0);
    with_hole.polygon.holes = (key_list){.count = 1, .items = &holes[0]};
    check_refused(&with_hole, 1, "shape 1 (polygon", "hole 1 does not lie inside");
    holes[0] = holes[1];
    with_hole.polygon.holes.count = 2;
    check_refused(&with_hole, 1, "shape 1 (polygon", "holes 1 and 2 overlap");
}

static void loops_are_turned_moved_and_ordered(void)
{
    // clockwise, and closed by a repeated corner, as people write them too
    const double square[] = {1, 1, 1, -1, -1, -1, -1, 1, 1, 1};
    shape_spec p = a_polygon(5, square, 0);
    p.polygon.angle = fixed(PI / 4);
    p.polygon.centre[0] = fixed(10);
    section_outline o = {0};
    CHECK_OK(freeze(1, &p, &o));
    CHECK(o.items[0].loop_start[1] == 4);
    double lowest = 0, left = 20;
    for (int i = 0; i < 4; i++) {
        left = fmin(left, o.items[0].point[2 * i]);
        lowest = fmin(lowest, o.items[0].point[2 * i + 1]);
    }
    CHECK_NEAR(left, 10 - sqrt(2), 1e-14);
    CHECK_NEAR(lowest, -sqrt(2), 1e-14);
    CHECK_NEAR(o.size, 10 + sqrt(2), 1e-14);
    CHECK_NEAR(o.turn, PI / 4, 1e-15);
    const double *q = o.items[0].point;
    CHECK((q[2] - q[0]) * (q[5] - q[1]) > (q[4] - q[0]) * (q[3] - q[1])); // counter-clockwise
    section_outline_free(&o);
}

static void the_last_sector_declares_turn_and_symmetry(void)
{
    const struct {
        shape_spec extra;
        bool symmetric;
    } trials[] = {
        {a_disc(1e-4, 3.6e-3 * cos(1.0), 3.6e-3 * sin(1.0), -1), true},
        {a_disc(1e-4, -3.6e-3 * cos(1.0), -3.6e-3 * sin(1.0), -1), true},
        {a_disc(1e-4, 3.6e-3, 0, -1), false},
        {a_sector(4e-3, 3.2e-3, 1.0 + PI, 0.3, 0), true},
        {a_sector(4e-3, 3.2e-3, 1.4, 0.3, 0), false},
        {a_rectangle(1e-4, 2e-4, 1.0 - PI / 2, 3.6e-3 * cos(1.0), 3.6e-3 * sin(1.0), 0), true},
        {a_rectangle(1e-4, 2e-4, 0, 3.6e-3 * cos(1.0), 3.6e-3 * sin(1.0), 0), false},
    };
    for (size_t i = 0; i < sizeof trials / sizeof *trials; i++) {
        const shape_spec shapes[] = {an_annulus(4e-3, 3.2e-3, 0), trials[i].extra,
                                     a_sector(4e-3, 3.2e-3, 1.0, 0.4, 1)};
        section_outline o = {0};
        CHECK_OK(freeze(3, shapes, &o));
        CHECK_NEAR(o.turn, 1.0, 1e-15);
        CHECK(o.has_symmetry == trials[i].symmetric);
        section_outline_free(&o);
    }
    // a pair that mirrors onto each other
    const shape_spec pair[] = {an_annulus(4e-3, 3.2e-3, 0), a_sector(4e-3, 3.2e-3, 0, 0.4, 1),
                               a_disc(1e-4, -3e-3, 1e-3, -1), a_disc(1e-4, -3e-3, -1e-3, -1)};
    section_outline o = {0};
    CHECK_OK(freeze(4, pair, &o));
    CHECK(o.has_symmetry);
    section_outline_free(&o);
}

static void a_turned_section_is_recognised(void)
{
    const double triangle[] = {0, 0, 1e-3, 0, 0, 2e-3};
    for (int wrong = 0; wrong < 2; wrong++) {
        section_outline o[2] = {{0}, {0}};
        for (int k = 0; k < 2; k++) {
            const double turn = k * 2.5, c = cos(turn), s = sin(turn);
            shape_spec shapes[] = {an_annulus(4e-3, 3.2e-3, 0), a_sector(4e-3, 3.2e-3, turn, 1, 1),
                                   a_disc(1e-4, 3.5e-3 * c, 3.5e-3 * s, -1),
                                   a_rectangle(1e-3, 2e-3, turn + k * PI, 2e-3 * c, 2e-3 * s, 0),
                                   a_polygon(3, triangle, 1)};
            shapes[4].polygon.angle = fixed(turn + wrong * k * 1e-3);
            CHECK_OK(freeze(5, shapes, &o[k]));
        }
        double angle = 0;
        CHECK(section_outline_is_turned(&o[0], &o[1], 1e-9, &angle) == !wrong);
        CHECK_NEAR(angle, 2.5, 1e-15);
        section_outline_free(&o[0]);
        section_outline_free(&o[1]);
    }
}

static double twice(const void *expression, double s)
{
    return *(const double *)expression * s;
}

static void what_varies_along_the_rod_freezes_at_its_place(void)
{
    const double two = 2;
    shape_spec s = a_sector(4e-3, 3.2e-3, 0, 1, 0);
    CHECK(!shapes_vary((shape_list){.count = 1, .items = &s}));
    s.sector.mid_angle = (field){.at = twice, .expression = &two};
    CHECK(shapes_vary((shape_list){.count = 1, .items = &s}));
    section_outline o = {0};
    CHECK_OK(freeze(1, &s, &o));
    CHECK_NEAR(o.items[0].mid_angle, 1.0, 1e-15); // at s = 0.5
    section_outline_free(&o);
}

int main(void)
{
    bad_numbers_are_refused_with_the_shape();
    the_arclength_is_told_where_something_varies();
    bad_polygons_are_refused();
    loops_are_turned_moved_and_ordered();
    the_last_sector_declares_turn_and_symmetry();
    a_turned_section_is_recognised();
    what_varies_along_the_rod_freezes_at_its_place();
    return test_failures != 0;
}
