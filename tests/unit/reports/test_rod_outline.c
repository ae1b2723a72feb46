// tests/unit/reports/test_rod_outline.c
#include "reports/rod_outline.h"
#include "tests/test.h"
#include "tests/unit/reports/synthetic.h"

#include <math.h>
#include <string.h>

enum { RINGS = 5 };

// the synthetic ring has 16 elements around, each cut in two: 1 - sinc(2 pi / 32) = 0.0064
static const double polygon_error = 7e-3;

static double area_of(const rod_outline *o, int from, int n)
{
    double sum = 0;
    for (int i = 0; i < n; i++) {
        const double *a = o->point[from + i], *b = o->point[from + (i + 1) % n];
        sum += (a[0] * b[1] - a[1] * b[0]) / 2;
    }
    return sum;
}

static void at_equal_steps(double length, double *s)
{
    for (int k = 0; k < RINGS; k++) {
        s[k] = length * k / (RINGS - 1);
    }
}

static void a_tube_has_two_loops_and_its_strip(void)
{
    run_result r = {0};
    rod_outline o = {0};
    double s[RINGS];
    CHECK_OK(synthetic_make(2, 0, 0.5, &r));
    at_equal_steps(r.rod_length, s);
    CHECK_OK(rod_outline_make(&r, RINGS, s, &o));
    CHECK(o.nloop == 2 && !o.plain && o.why[0] == '\0');
    CHECK_NEAR(area_of(&o, 0, o.loop[0]), pi * 16e-6, polygon_error);
    CHECK_NEAR(area_of(&o, o.loop[0], o.loop[1]), -pi * 10.24e-6, polygon_error);
    CHECK_NEAR(o.radius, 4e-3, 1e-9);
    CHECK(o.used[0] && o.used[1] && !o.used[2]);
    // the strip lies at -x, a sixteenth of the way around
    double stiff = 0;
    for (int i = 0; i < o.loop[0]; i++) {
        const double *a = o.point[i], *b = o.point[(i + 1) % o.loop[0]];
        stiff += o.ink[i] == 1 ? hypot(b[0] - a[0], b[1] - a[1]) : 0;
        CHECK(o.ink[i] != 1 || a[0] < -3.5e-3);
    }
    CHECK_NEAR(stiff, pi / 8 * 4e-3, 0.01);
    for (int k = 0; k < RINGS; k++) {
        CHECK(o.turn[k] == 0);
    }
    rod_outline_free(&o);
    synthetic_free(&r);
}

static void a_pattern_turns_as_the_law_does(void)
{
    run_result r = {0};
    rod_outline o = {0};
    double s[RINGS];
    CHECK_OK(synthetic_make(2, 1, 0.5, &r)); // half a turn along the rod
    law_along *along = &r.section.along;
    CHECK(along->nnode > 1);
    at_equal_steps(r.rod_length, s);
    CHECK_OK(rod_outline_make(&r, RINGS, s, &o));
    CHECK(!o.plain && o.why[0] == '\0');
    for (int k = 0; k < RINGS; k++) {
        CHECK_NEAR(1 + o.turn[k], 1 + pi * k / (RINGS - 1), 1e-12);
    }
    rod_outline_free(&o);

    // where it changes besides it is still seen turning, which is told
    along->law[along->nnode - 1].K.a[2][2] *= 0.5;
    CHECK_OK(rod_outline_make(&r, RINGS, s, &o));
    CHECK(!o.plain && strstr(o.why, "turned as it turns"));
    CHECK_NEAR(o.turn[RINGS - 1], pi, 1e-12);
    rod_outline_free(&o);

    for (int i = 0; i < along->nnode; i++) {
        along->turn[i] = 0;
    }
    CHECK_OK(rod_outline_make(&r, RINGS, s, &o));
    CHECK(o.plain && strstr(o.why, "in one colour"));
    rod_outline_free(&o);
    synthetic_free(&r);
}

static void what_was_not_meshed_is_a_circle_of_its_area(void)
{
    run_result r = {0};
    rod_outline o = {0};
    double s[RINGS] = {0, NAN, INFINITY, -1e308, 1e308};
    CHECK_OK(synthetic_make(1, 0, 0.5, &r));
    mesh_free(&r.section_mesh);
    CHECK_OK(rod_outline_make(&r, RINGS, s, &o)); // no place along a rod at all
    CHECK(o.nloop == 1 && o.plain && strstr(o.why, "full circle of its area"));
    CHECK_NEAR(area_of(&o, 0, o.npoint), r.section.station[0].law.area, polygon_error);
    for (int k = 0; k < RINGS; k++) {
        CHECK(isfinite(o.turn[k]));
    }
    rod_outline_free(&o);
    r.has_section = false;
    CHECK_OK(rod_outline_make(&r, 1, s, &o)); // one point along, nothing known
    CHECK_NEAR(o.radius, r.rod_length / 60, 1e-12);
    rod_outline_free(&o);
    r.has_section = true;
    synthetic_free(&r);
}

static void a_shape_at_rest_that_nobody_told_is_none(void)
{
    run_result r = {0};
    CHECK_OK(synthetic_make(1, 0, 0.5, &r));
    rod_result rod = r.rod;
    rod.rest = NULL;
    CHECK(!rod_rest_is_known(&rod));
    pose zero = {0};
    rod.rest = &zero;
    CHECK(!rod_rest_is_known(&rod));
    synthetic_free(&r);
}

int main(void)
{
    a_tube_has_two_loops_and_its_strip();
    a_pattern_turns_as_the_law_does();
    what_was_not_meshed_is_a_circle_of_its_area();
    a_shape_at_rest_that_nobody_told_is_none();
    return test_failures != 0;
}
