#include "meshes/loops.h"
#include "meshes/outline_move.h"
#include "tests/shapes.h"
#include "tests/test.h"

static section_outline frozen(int n, const shape_spec *s, double at)
{
    section_outline o = {0};
    CHECK_OK(shapes_at((shape_list){.count = n, .items = s}, at, &o));
    return o;
}

static void check_refused(shape_spec s, const char *why)
{
    section_outline o = {0};
    CHECK(shapes_at((shape_list){.count = 1, .items = &s}, 0, &o) == ERR_INPUT);
    if (!strstr(status_message(), why)) {
        printf("message: %s, wanted: %s\n", status_message(), why);
        CHECK(false);
    }
    status_clear();
    section_outline_free(&o);
}

static void points_lie_inside_or_outside_of_curves(void)
{
    const double star[] = {2, 0, 0.7, 0.7, 0, 2, -0.7, 0.7, -2, 0, -0.7, -0.7, 0, -2, 0.7, -0.7};
    const shape_spec s[] = {an_ellipse(3, 1, 0.5, 0.2, -0.1, 0),
                            a_rounded_rectangle(4, 2, 0.5, 0.3, 0), a_spline(8, star, 0)};
    section_outline o = frozen(3, s, 0);
    for (int i = 0; i < 60; i++) {
        for (int j = 0; j < 60; j++) {
            const double x = -3.1 + 0.10417 * i, y = -3.2 + 0.10713 * j;
            // own axes
            const double c = cos(0.5), n = sin(0.5), dx = x - 0.2, dy = y + 0.1;
            const double u = c * dx + n * dy, v = c * dy - n * dx;
            CHECK(outline_contains(&o.items[0], x, y) == (u * u / 9 + v * v < 1));
            const double p = fabs(cos(0.3) * x + sin(0.3) * y),
                         q = fabs(cos(0.3) * y - sin(0.3) * x);
            const bool corner = p > 1.5 && q > 0.5;
            CHECK(outline_contains(&o.items[1], x, y) ==
                  (corner ? hypot(p - 1.5, q - 0.5) < 0.5 : p < 2 && q < 1));
        }
    }
    CHECK(outline_contains(&o.items[2], 1.9, 0) && !outline_contains(&o.items[2], 1.2, 1.2));
    CHECK(outline_contains(&o.items[2], 0, 0) && !outline_contains(&o.items[2], 2.1, 0));
    section_outline_free(&o);
}

static void curves_find_their_own_points_again(void)
{
    const double control[] = {0, 0, 3, 2, -2, 2, 1, 0}, centre[] = {1, 2};
    const carrier c[] = {carrier_cubic(control), carrier_arc(centre, 5, 0.05, 0.7, 0.3, 1.2)};
    for (int k = 0; k < 2; k++) {
        for (int i = 0; i <= 20; i++) {
            const double t = c[k].from + (c[k].to - c[k].from) * i / 20;
            double x[2], y[2], found;
            carrier_point(&c[k], t, x);
            CHECK(carrier_distance(&c[k], x, &found) < 1e-14);
            carrier_point(&c[k], found, y);
            CHECK(hypot(x[0] - y[0], x[1] - y[1]) < 1e-14);
        }
    }
}

static double linear(const void *rate, double s)
{
    return *(const double *)rate * s;
}

// the whole pattern turns with s: ellipses and arrays tell by how much
static void turning_patterns_are_known_as_such(void)
{
    static const double rate = 25;
    const field angle = {.at = linear, .expression = &rate};
    shape_spec s[] = {a_disc(2e-3, 0, 0, 0), an_ellipse(1.5e-3, 0.4e-3, 0, 0, 0, 1),
                      lumens_on_a_circle(0.1e-3, 3, 1.7e-3, 0, -1)};
    s[1].ellipse.angle = angle;
    s[2].lumens.first_angle = angle;
    CHECK(shapes_vary((shape_list){.count = 3, .items = s}));
    section_outline a = frozen(3, s, 0), b = frozen(3, s, 0.02);
    double by = 0;
    CHECK(a.count == 5);
    CHECK(section_outline_is_turned(&a, &b, 1e-12, &by));
    CHECK_NEAR(by, rate * 0.02, 1e-14);
    b.items[1].piece[2].p[1][0] *= 1 + 1e-6;
    CHECK(!section_outline_is_turned(&a, &b, 1e-12, &by));
    section_outline_free(&a);
    section_outline_free(&b);
}

// a mirrored, scaled and turned copy is the one drawn there
static void curves_move_as_a_whole(void)
{
    const shape_spec s = an_ellipse(2, 1, 0.3, 1, 0.5, 0),
                     there = an_ellipse(4, 2, 0.7 - 0.3, 2 * (cos(0.7) + 0.5 * sin(0.7)),
                                        2 * (sin(0.7) - 0.5 * cos(0.7)), 0);
    section_outline o = frozen(1, &s, 0), wanted = frozen(1, &there, 0), copy = {0};
    const outline_motion motion = {.mirror = true, .scale = 2, .angle = 0.7};
    double by = 0, none = 0;
    CHECK_OK(section_outline_copy(&o, &copy));
    section_outline_move(&copy, &motion);
    CHECK(curves_area(outline_curves(&copy.items[0], 0)) > 0);
    wanted.turn = copy.turn = 0;
    CHECK(section_outline_is_turned(&copy, &wanted, 1e-12, &none));
    const outline_motion turn = {.scale = 1.2, .angle = 0.1};
    section_outline_free(&copy);
    CHECK_OK(section_outline_copy(&o, &copy));
    section_outline_move(&copy, &turn);
    CHECK(section_outline_spin(&o, &copy, 1e-12, &by));
    CHECK_NEAR(by, 0.1, 1e-13);
    section_outline_free(&o);
    section_outline_free(&wanted);
    section_outline_free(&copy);
}

static void copies_are_turned_or_only_moved(void)
{
    const shape_spec s[] = {in_array(an_ellipse(2, 1, 0.1, 5, 0, 0), 4, 0.2, true),
                            in_array(an_ellipse(2, 1, 0.1, 5, 0, 0), 4, 0.2, false)};
    section_outline o = frozen(2, s, 0);
    CHECK(o.count == 8);
    for (int i = 0; i < 8; i++) {
        const double at = 0.2 + PI / 2 * (i % 4), own = 0.1 + (i < 4 ? at : 0);
        const double x = 5 * cos(at), y = 5 * sin(at);
        CHECK(outline_contains(&o.items[i], x + 1.99 * cos(own), y + 1.99 * sin(own)));
        CHECK(!outline_contains(&o.items[i], x + 2.01 * cos(own), y + 2.01 * sin(own)));
        CHECK(!outline_contains(&o.items[i], x - 1.01 * sin(own), y + 1.01 * cos(own)));
    }
    CHECK(strcmp(o.items[2].called, "shape 1 (ellipse, copy 3)") == 0);
    section_outline_free(&o);
}

// a sector with mirrored lumens and an ellipse along it: its middle is an axis of symmetry
static void symmetry_is_seen_through_curves(void)
{
    shape_spec s[] = {a_disc(2, 0, 0, 0), a_sector(2, 1, 0.7, 1, 1),
                      an_ellipse(0.4, 0.2, 0.7, -cos(0.7), -sin(0.7), -1),
                      lumens_on_a_circle(0.1, 6, 0.7, 0.7, -1)};
    section_outline o = frozen(4, s, 0);
    CHECK(o.has_symmetry);
    CHECK_NEAR(o.turn, 0.7, 0);
    section_outline_free(&o);
    s[2].ellipse.angle = fixed(0.8);
    o = frozen(4, s, 0);
    CHECK(!o.has_symmetry);
    section_outline_free(&o);
}

static void what_cannot_be_is_refused_by_name(void)
{
    const double eight[] = {-2, -1, 2, 1, 2, -1, -2, 1}, same[] = {0, 0, 1, 0, 1, 0, 0, 1};
    const double line[] = {0, 0, 1, 0}, outer[] = {3, 0, 0, 3, -3, 0, 0, -3};
    const double out[] = {5, 0, 4, 1, 4, -1};
    check_refused(an_ellipse(1, -1, 0, 0, 0, 0), "shape 1 (ellipse): its semi_axis_y is -1000 mm");
    check_refused(an_ellipse(NAN, 1, 0, 0, 0, 0), "semi_axis_x is not a finite number");
    check_refused(a_rounded_rectangle(2, 1, 0.6, 0, 0), "corner_radius of 600 mm is not between");
    check_refused(a_spline(4, eight, 0), "of its outline cross");
    check_refused(a_spline(4, same, 0), "points 2 and 3 of its spline are one");
    check_refused(a_spline(2, line, 0), "three points");
    check_refused(lumens_on_a_circle(0.1, 3, 0, 0, 0), "copy 1): its circle_radius is 0 mm");
    check_refused(in_array(lumens_on_a_circle(0.1, 100, 1, 0, 0), 100, 0, true), "more than");
    check_refused(an_ellipse(1e200, 1e200, 0, 1e308, 0, 0), "it reaches");
    shape_spec holed = a_spline(4, outer, 0);
    hole_spec hole = {.points = {.nrow = 3, .ncol = 2, .a = (double *)(size_t)out}};
    holed.spline.holes = (key_list){.count = 1, .items = &hole};
    check_refused(holed, "hole 1 does not lie inside");
}

int main(void)
{
    points_lie_inside_or_outside_of_curves();
    curves_find_their_own_points_again();
    turning_patterns_are_known_as_such();
    curves_move_as_a_whole();
    copies_are_turned_or_only_moved();
    symmetry_is_seen_through_curves();
    what_cannot_be_is_refused_by_name();
    return test_failures != 0;
}
