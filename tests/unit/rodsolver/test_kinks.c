// tests/unit/rodsolver/test_kinks.c
// Kinks and jumps of what varies along the rod become edges of panels.
#include "rodsolver/kinks.h"
#include "tests/unit/rodsolver/prototypes.h"

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

static void kinks_of_paths_are_found_and_bends_are_none(void)
{
    double at[MOST_KINKS];
    tendon_spec t = {.radius = field_constant(3.6e-3), .end = 0.1};
    CHECK(kinks_of_tendon(&t, at) == 0);
    t.angle = (field){.at = zigzag};
    CHECK(kinks_of_tendon(&t, at) == 3);
    CHECK_WITHIN(at[0], 0.0401, 1e-12);
    CHECK_WITHIN(at[1], 0.05, 1e-12); // on a sample
    CHECK_WITHIN(at[2], 0.09123, 1e-12);
    t.angle = (field){.at = bent};
    CHECK(kinks_of_tendon(&t, at) == 1);
    CHECK_WITHIN(at[0], 0.0437, 1e-8);
    const double rate[4] = {0, 20, -60, 300};
    for (int i = 0; i < 4; i++) {
        t.angle = (field){.at = smooth, .expression = &rate[i]};
        CHECK(kinks_of_tendon(&t, at) == 0);
    }
}

// a load that begins within its stretch, and one that is cut off
static double ramp(const void *scale, double s)
{
    return *(const double *)scale * (fmax(0, s - 0.0313) + 0.2 * fmin(s, 0.0777));
}

static double step(const void *scale, double s)
{
    return *(const double *)scale * ((s > 0.0313) - 0.3 * (s >= 0.08) + 3 * s);
}

static double wave(const void *scale, double s)
{
    return *(const double *)scale * (1e3 + sin(80 * s));
}

// whatever the field's unit
static void kinks_and_jumps_of_fields_are_found(void)
{
    const double scale[3] = {1, 1e-9, 1e9};
    double at[MOST_KINKS];
    for (int i = 0; i < 3; i++) {
        const field ramps = {.at = ramp, .expression = &scale[i]};
        CHECK(kinks_of_field(&ramps, 0, 0.12, at) == 2);
        CHECK_WITHIN(at[0], 0.0313, 1e-11);
        CHECK_WITHIN(at[1], 0.0777, 1e-11);
        CHECK(kinks_of_field(&ramps, 0.04, 0.06, at) == 0);
        const field steps = {.at = step, .expression = &scale[i]};
        CHECK(kinks_of_field(&steps, 0, 0.12, at) == 2);
        CHECK_WITHIN(at[0], 0.0313, 1e-16);
        CHECK_WITHIN(at[1], 0.08, 1e-16);
        const field waves = {.at = wave, .expression = &scale[i]};
        CHECK(kinks_of_field(&waves, 0, 0.12, at) == 0);
    }
    const field constant = field_constant(3);
    CHECK(kinks_of_field(&constant, 0, 0.12, at) == 0);
}

static double pole(const void *unused, double s)
{
    (void)unused;
    return 1 / s;
}

static double hole(const void *unused, double s)
{
    (void)unused;
    return s > 0.05 ? NAN : 1;
}

static double saw(const void *unused, double s)
{
    (void)unused;
    return remainder(s, 0.003);
}

static void hostile_fields_do_no_harm(void)
{
    double at[MOST_KINKS];
    const field bad[3] = {{.at = pole}, {.at = hole}, {.at = saw}};
    for (int i = 0; i < 3; i++) {
        const int n = kinks_of_field(&bad[i], 0, 0.12, at);
        CHECK(n >= 0 && n <= MOST_KINKS);
        for (int k = 0; k < n; k++) {
            CHECK(at[k] >= 0 && at[k] <= 0.12);
        }
    }
    CHECK(kinks_of_field(&bad[2], 0.1, 0.1, at) == 0);
}

static double bend(const void *expression, double s)
{
    return 20 + *(const double *)expression * fabs(s - 0.0437);
}

static double bend_in_pieces(const void *expression, double s)
{
    return s < *(const double *)expression ? 30 : -10;
}

// a precurved rod whose curvature has a kink: the quadrature keeps its order, since a
// panel ends there
static void rest_shapes_keep_the_order(void)
{
    const prototype p = homogeneous_tube();
    const double strong = 900;
    law_along law = {0};
    prototype_law(&p, &law);
    const rod_spec spec = {
        .law = &law,
        .rest = {.curvature_x = {.at = bend, .expression = &strong}, .twist = field_constant(15)}};
    double h[4], error[4];
    vec3 tip[5];
    for (int i = 0; i < 5; i++) {
        rod *r = NULL;
        rod_state *state = NULL;
        rod_solution out = {0};
        CHECK_OK(rod_make(&spec, &(rod_options){.npanel = i == 4 ? 512 : 16 << i}, &r));
        CHECK_OK(rod_state_make(r, &state));
        CHECK_OK(rod_solve(state, &(rod_request){.cold = true}, &out));
        tip[i] = out.tip.p;
        rod_state_free(state);
        rod_free(r);
    }
    for (int i = 0; i < 3; i++) {
        h[i] = 1.0 / (1 << i);
        error[i] = distance(tip[i], tip[4]);
    }
    CHECK(error[0] > 1e-11);                  // the order can be seen
    CHECK(observed_order(3, h, error) > 5.4); // 6 less what pairs beside the kink are not halved
    law_along_free(&law);
}

// two arcs of constant curvature, one after the other: exact in closed form with the fewest panels
static void curvatures_may_jump(void)
{
    const prototype p = homogeneous_tube();
    const double at = 0.0437;
    law_along law = {0};
    prototype_law(&p, &law);
    const rod_spec spec = {.law = &law,
                           .rest = {.curvature_y = {.at = bend_in_pieces, .expression = &at}}};
    rod *r = NULL;
    rod_state *state = NULL;
    rod_solution out = {0};
    CHECK_OK(rod_make(&spec, &(rod_options){.npanel = 2}, &r));
    CHECK_OK(rod_state_make(r, &state));
    CHECK_OK(rod_solve(state, &(rod_request){.cold = true}, &out));
    const double a = 30 * at, b = a - 10 * (p.length - at);
    const double x = (1 - cos(a)) / 30 + (cos(b) - cos(a)) / 10;
    const double z = sin(a) / 30 + (sin(a) - sin(b)) / 10;
    CHECK_WITHIN(out.tip.p.a[0], x, 1e-15);
    CHECK_WITHIN(out.tip.p.a[1], 0, 1e-15);
    CHECK_WITHIN(out.tip.p.a[2], z, 1e-15);
    rod_state_free(state);
    rod_free(r);
    law_along_free(&law);
}

int main(void)
{
    kinks_of_paths_are_found_and_bends_are_none();
    kinks_and_jumps_of_fields_are_found();
    hostile_fields_do_no_harm();
    rest_shapes_keep_the_order();
    curvatures_may_jump();
    return test_failures != 0;
}
