// tests/unit/rodsolver/test_routing.c
#include "rodsolver/routing.h"
#include "tests/test.h"

static double linear(const void *expression, double s)
{
    return *(const double *)expression * s;
}

static void straight_tendon_has_no_slope(void)
{
    const tendon_spec t = {.radius = field_constant(3e-3),
                           .angle = field_constant(0.5),
                           .x = field_constant(1e-3),
                           .y = field_constant(-2e-3)};
    routing path;
    routing_make(&t, NULL, 0, 0.1, &path);
    const tendon_place p = routing_at(&path, 0.03);
    CHECK_NEAR(p.x, 1e-3 + 3e-3 * cos(0.5), 1e-15);
    CHECK_NEAR(p.y, -2e-3 + 3e-3 * sin(0.5), 1e-15);
    CHECK(p.dx == 0 && p.dy == 0);
}

// a conical helix: place and slope against their closed forms, at and between the nodes
static void helix_has_its_closed_form_slope(void)
{
    const double turn = 60, taper = 0.02; // half a turn over the stretch
    const tendon_spec t = {.radius = {.at = linear, .expression = &taper},
                           .angle = {.at = linear, .expression = &turn}};
    routing path;
    routing_make(&t, NULL, 0.05, 0.1, &path);
    for (int i = 0; i <= 20; i++) {
        const double s = 0.05 + 0.05 * i / 20, r = taper * s, a = turn * s;
        const tendon_place p = routing_at(&path, s);
        CHECK_WITHIN(p.x, r * cos(a), 1e-16);
        CHECK_WITHIN(p.y, r * sin(a), 1e-16);
        CHECK_WITHIN(p.dx, taper * cos(a) - r * turn * sin(a), 1e-11);
        CHECK_WITHIN(p.dy, taper * sin(a) + r * turn * cos(a), 1e-11);
    }
}

static double square(const void *expression, double s)
{
    return *(const double *)expression * s * s;
}

// x and y as polynomials of s, on top of a polar place
static void polynomial_has_its_exact_slope(void)
{
    const double slope = 0.05, bend = -0.4;
    const tendon_spec t = {.radius = field_constant(1e-3),
                           .x = {.at = linear, .expression = &slope},
                           .y = {.at = square, .expression = &bend}};
    routing path;
    routing_make(&t, NULL, 0.02, 0.05, &path);
    for (int i = 0; i <= 10; i++) {
        const double s = 0.02 + 0.003 * i;
        const tendon_place p = routing_at(&path, s);
        CHECK_NEAR(p.x, 1e-3 + slope * s, 1e-14);
        CHECK_NEAR(p.y, bend * s * s, 1e-14);
        CHECK_NEAR(p.dx, slope, 1e-12);
        CHECK_NEAR(p.dy, 2 * bend * s, 1e-12);
    }
}

int main(void)
{
    straight_tendon_has_no_slope();
    helix_has_its_closed_form_slope();
    polynomial_has_its_exact_slope();
    return test_failures != 0;
}
