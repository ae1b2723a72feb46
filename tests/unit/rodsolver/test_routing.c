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
    routing_make(&t, 0, 0.1, &path);
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
    routing_make(&t, 0.05, 0.1, &path);
    for (int i = 0; i <= 20; i++) {
        const double s = 0.05 + 0.05 * i / 20, r = taper * s, a = turn * s;
        const tendon_place p = routing_at(&path, s);
        CHECK_WITHIN(p.x, r * cos(a), 1e-16);
        CHECK_WITHIN(p.y, r * sin(a), 1e-16);
        CHECK_WITHIN(p.dx, taper * cos(a) - r * turn * sin(a), 1e-11);
        CHECK_WITHIN(p.dy, taper * sin(a) + r * turn * cos(a), 1e-11);
    }
}

static double zigzag(const void *expression, double s)
{
    (void)expression;
    return 20 * (fabs(s - 0.0401) - 0.1 * fabs(s - 0.05) + 2 * fmax(0, s - 0.09123)) + 30 * s;
}

// its direction is continuous, its curvature is not
static double bent(const void *expression, double s)
{
    (void)expression;
    return 20 * s + 700 * (s - 0.0437) * fabs(s - 0.0437);
}

static double smooth(const void *expression, double s)
{
    return *(const double *)expression * s + 0.3 * sin(90 * s);
}

static void kinks_are_found_and_bends_are_none(void)
{
    double at[ROUTING_MAX_KINKS];
    tendon_spec t = {.radius = field_constant(3.6e-3), .end = 0.1};
    CHECK(routing_kinks(&t, at) == 0);
    t.angle = (field){.at = zigzag};
    CHECK(routing_kinks(&t, at) == 3);
    CHECK_WITHIN(at[0], 0.0401, 1e-12);
    CHECK_WITHIN(at[1], 0.05, 1e-12); // on a sample
    CHECK_WITHIN(at[2], 0.09123, 1e-12);
    t.angle = (field){.at = bent};
    CHECK(routing_kinks(&t, at) == 1);
    CHECK_WITHIN(at[0], 0.0437, 1e-8);
    const double rate[4] = {0, 20, -60, 300};
    for (int i = 0; i < 4; i++) {
        t.angle = (field){.at = smooth, .expression = &rate[i]};
        CHECK(routing_kinks(&t, at) == 0);
    }
}

int main(void)
{
    straight_tendon_has_no_slope();
    helix_has_its_closed_form_slope();
    kinks_are_found_and_bends_are_none();
    return test_failures != 0;
}
