// measure/shape_error.h against values worked by hand.
#include "measure/shape_error.h"

#include "base/memory.h"
#include "tests/test.h"

enum { MOST = 4001 };

typedef struct lines {
    double s[MOST], along[MOST];
    vec3 p[MOST], slope[MOST];
    model_line model;
    centreline measured;
} lines;

typedef vec3 curve(double s, bool slope);

static void model_of(lines *l, int n, double length, curve *f)
{
    for (int i = 0; i < n; i++) {
        l->s[i] = length * i / (n - 1);
        l->p[i] = f(l->s[i], false);
        l->slope[i] = f(l->s[i], true);
    }
    l->model = (model_line){n, l->s, l->p, l->slope, l->along};
    model_line_lengths(&l->model, l->along);
}

static void measured_at(lines *l, int n, const double *s, curve *f)
{
    CHECK_OK(centreline_make(n, &l->measured));
    for (int i = 0; i < n; i++) {
        l->measured.s[i] = s[i];
        l->measured.p[i] = f(s[i], false);
        l->measured.sigma[i] = NAN;
    }
}

static vec3 straight(double s, bool slope)
{
    return slope ? (vec3){{0, 0, 1}} : (vec3){{0, 0, s}};
}

// p - straight = (3 s / 5, 0, -s / 5): a 3-4-5 direction, distance s sqrt(2/5)
static vec3 leaning(double s, bool slope)
{
    return slope ? (vec3){{0.6, 0, 0.8}} : (vec3){{0.6 * s, 0, 0.8 * s}};
}

static const shape_way at_rest = {ARCLENGTH_REST, TIP_BY_LENGTH};

static shape_error error_of(const lines *l, shape_way way)
{
    shape_error e = {0};
    centreline matched = {0};
    bool tip = false;
    double longer = NAN;
    CHECK_OK(shape_match(&l->model, &l->measured, &way, &matched, &tip, &longer));
    CHECK_OK(shape_error_find(&l->model, &matched, tip, &e));
    e.longer = longer;
    centreline_free(&matched);
    return e;
}

// Straight lines of length 2 under the angle whose cosine is 4/5: |d| = s sqrt(9/25 + 1/25), so
// |d|/s = sqrt(2/5) everywhere; tip 2 sqrt(2/5), mean of s over [0, 2] is 1, of s^2 it is 4/3
static void two_straight_lines(void)
{
    static lines l;
    const double s[5] = {0, 0.3, 0.7, 1.9, 2}, c = sqrt(2.0 / 5);
    model_of(&l, 3, 2, straight);
    measured_at(&l, 5, s, leaning);
    const shape_error e = error_of(&l, at_rest);
    CHECK_NEAR(e.shape, c, 1e-12);
    CHECK_NEAR(e.tip, 2 * c, 1e-12);
    CHECK_NEAR(e.mean, c, 1e-12);
    CHECK_NEAR(e.rms, c * sqrt(4.0 / 3), 1e-12);
    CHECK_NEAR(e.largest, 2 * c, 1e-12);
    CHECK_NEAR(e.at, 2, 1e-12);
    CHECK_NEAR(e.tip_angle, acos(0.8), 1e-12);
    CHECK(e.base == 0 && e.from == 0 && e.to == 2);
    centreline_free(&l.measured);
}

// p - straight = (s (s - 1/3) (1 - s / 2), 0, 0)
static vec3 crossing(double s, bool slope)
{
    (void)slope;
    return (vec3){{s * (s - 1.0 / 3) * (1 - s / 2), 0, s}};
}

// The stored example: a cubic offset on [0, 1] that changes sides at 1/3, five stations against
// eight. |d|/s = |(s - 1/3)(1 - s/2)|; F(s) = int (s - 1/3)(1 - s/2) = -s/3 + 7 s^2/12 - s^3/6;
// F(1/3) = -1/9 + 7/108 - 1/162 = (-36 + 21 - 2)/324 = -17/324; F(1) = (-4 + 7 - 2)/12 = 1/12 =
// 27/324; the integral of the size is F(1) - 2 F(1/3) = (27 + 34)/324 = 61/324.
// Tip 2/3 1/2 = 1/3. int d^2 = int s^2 (s - 1/3)^2 (1 - s/2)^2: d = -s/3 + 7 s^2/6 - s^3/2, so
// d^2 = s^2/9 - 7 s^3/9 + (49/36 + 1/3) s^4 - 7 s^5/6 + s^6/4, integral
// 1/27 - 7/36 + 61/180 - 7/36 + 1/28 = (140 - 735 + 1281 - 735 + 135)/3780 = 86/3780 = 43/1890.
static void the_stored_example(void)
{
    static lines l;
    const double s[8] = {0, 0.05, 0.2, 0.45, 0.5, 0.8, 0.95, 1};
    model_of(&l, 5, 1, straight);
    measured_at(&l, 8, s, crossing);
    const shape_error e = error_of(&l, at_rest);
    CHECK_NEAR(e.shape, 61.0 / 324, 1e-12);
    CHECK_NEAR(e.tip, 1.0 / 3, 1e-12);
    CHECK_NEAR(e.rms, sqrt(43.0 / 1890), 1e-12);
    // the measured tangent at the tip: x' = -1/3 + 7/3 - 3/2 = 1/2
    CHECK_WITHIN(e.tip_angle, atan(0.5), 0.03); // a parabola over the last tenth of a cubic
    CHECK(isnan(e.tip_sigma) && isnan(e.shape_sigma));
    centreline_free(&l.measured);
}

// Two arcs of curvature 2 over length 1 in planes 60 deg apart: |d| = 2 sin(30 deg) (1 - cos 2s)/2;
// the integral of (1 - cos t)/t from 0 to 2 is Cin(2) = sum of (-1)^(n+1) 2^(2n) / (2n (2n)!)
static vec3 arc_x(double s, bool slope)
{
    return slope ? (vec3){{sin(2 * s), 0, cos(2 * s)}}
                 : (vec3){{(1 - cos(2 * s)) / 2, 0, sin(2 * s) / 2}};
}

static vec3 arc_turned(double s, bool slope)
{
    const vec3 p = arc_x(s, slope);
    const double angle = acos(0.5);
    return (vec3){{p.a[0] * cos(angle), p.a[0] * sin(angle), p.a[2]}};
}

static double cin_of_2(void)
{
    double sum = 0, term = 1; // 2^(2n) / (2n)!
    for (int n = 1; n < 20; n++) {
        term *= 4.0 / ((2 * n - 1) * (2 * n));
        sum += (n % 2 ? 1 : -1) * term / (2 * n);
    }
    return sum;
}

static void two_arcs(void)
{
    static lines l;
    static double s[3001];
    for (int i = 0; i <= 3000; i++) {
        s[i] = i / 3000.0;
    }
    model_of(&l, 2001, 1, arc_x);
    measured_at(&l, 3001, s, arc_turned);
    const shape_error e = error_of(&l, at_rest);
    CHECK_NEAR(e.shape, cin_of_2() / 2, 1e-12);
    CHECK_NEAR(e.tip, (1 - cos(2.0)) / 2, 1e-12);
    // tangents (sin 2, 0, cos 2) and the same turned by 60 deg about z; the last tenth bends by
    // 0.2, and a parabola's slope is off by 0.1 0.2^2 at its end
    CHECK_NEAR(e.tip_angle, acos(0.5 * sin(2.0) * sin(2.0) + cos(2.0) * cos(2.0)), 4e-3);
    CHECK_WITHIN(e.longer, 0, 1e-12);
    centreline_free(&l.measured);
}

// Where the measured line lies off the base by h = 0.01 everywhere: up to its first station at 1/4
// the difference grows from 0, so int = h + h ln 4
static vec3 beside(double s, bool slope)
{
    return slope ? (vec3){{0, 0, 1}} : (vec3){{0.01, 0, s}};
}

static void a_line_that_misses_the_base(void)
{
    static lines l;
    const double s[4] = {0, 0.25, 0.75, 1};
    model_of(&l, 7, 1, straight);
    measured_at(&l, 4, s, beside);
    const shape_error e = error_of(&l, at_rest);
    CHECK_NEAR(e.shape, 0.01 * (1 + log(4.0)), 1e-12);
    CHECK_NEAR(e.base, 0.01, 1e-12);
    CHECK_NEAR(e.rms, 0.01, 1e-12);
    CHECK_WITHIN(e.tip_angle, 0, 1e-7);
    centreline_free(&l.measured);
}

// From 1/4 to 1/2 only: no tip; |d|/s = sqrt(2/5) over what was measured
static void a_part_of_the_rod(void)
{
    static lines l;
    const double s[3] = {0.25, 0.375, 0.5};
    model_of(&l, 3, 1, straight);
    measured_at(&l, 3, s, leaning);
    const shape_error e = error_of(&l, at_rest);
    CHECK_NEAR(e.shape, sqrt(2.0 / 5), 1e-12);
    CHECK(isnan(e.tip) && isnan(e.tip_angle) && isnan(e.base));
    CHECK(e.from == 0.25 && e.to == 0.5);
    centreline_free(&l.measured);
}

// a rod that is stretched by a fifth, evenly, along z
static vec3 stretched(double s, bool slope)
{
    return slope ? (vec3){{0, 0, 1.2}} : (vec3){{0, 0, 1.2 * s}};
}

// Measured along the line as it lies: tip to tip, whatever the lengths are
static void arclength_as_it_lies(void)
{
    static lines l;
    const double s[4] = {0, 0.4, 0.9, 1.21};
    model_of(&l, 9, 1, stretched);
    measured_at(&l, 4, s, straight);
    const shape_error e = error_of(&l, (shape_way){ARCLENGTH_MEASURED, TIP_BY_LENGTH});
    CHECK_NEAR(e.tip, 0.01, 1e-12);
    CHECK_NEAR(e.longer, 0.01, 1e-9);
    CHECK_NEAR(e.shape, 0.01, 1e-12); // d = 0.01 s
    CHECK_NEAR(e.to, 1, 1e-15);
    // longer than the model by less than a tenth: the tip it ends at is the rod's
    static const struct {
        double end;
        bool tip;
    } ends[] = {{0.979, false}, {0.981, true}, {1.05, true}, {1.099, true}, {1.101, false}};
    for (int i = 0; i < 5; i++) {
        const shape_way way = {ARCLENGTH_MEASURED, TIP_BY_LENGTH};
        CHECK(shape_ends_at_tip(&way, 0.12 * ends[i].end, 0.12) == ends[i].tip);
    }
    CHECK(shape_ends_at_tip(&(shape_way){ARCLENGTH_MEASURED, TIP_MEASURED}, 0.2, 0.12));
    CHECK(!shape_ends_at_tip(&(shape_way){ARCLENGTH_MEASURED, TIP_NOT_MEASURED}, 0.12, 0.12));
    // told that the line ends before the tip: places are met at equal lengths, and there is no
    // error
    const shape_error part = error_of(&l, (shape_way){ARCLENGTH_MEASURED, TIP_NOT_MEASURED});
    CHECK(isnan(part.tip));
    CHECK_WITHIN(part.rms, 0, 1e-14);
    // half a line by its length
    l.measured.count = 2;
    const shape_error half = error_of(&l, (shape_way){ARCLENGTH_MEASURED, TIP_BY_LENGTH});
    CHECK(isnan(half.tip));
    CHECK_NEAR(half.to, 1.0 / 3, 1e-12);
    l.measured.count = 4;
    centreline_free(&l.measured);
}

// Four stations at 1/4 .. 1 of a leaning line, sigma 1/100 each. d is along one direction, so
// dE = sum w_i e_i / s_i with the trapezoids' weights w = 3/8, 1/4, 1/4, 1/8 (the first has all of
// [0, 1/4]) and w/s = 3/2, 1/2, 1/3, 1/8. Independent: sqrt of 9/4 + 1/4 + 1/9 + 1/64; together:
// 59/24.
static void uncertainty_of_the_shape_error(void)
{
    static lines l;
    const double s[5] = {0, 0.25, 0.5, 0.75, 1};
    model_of(&l, 5, 1, straight);
    measured_at(&l, 5, s, leaning);
    for (int i = 0; i < 5; i++) {
        l.measured.sigma[i] = 0.01;
    }
    shape_error e = error_of(&l, at_rest);
    CHECK_NEAR(e.shape_sigma, 0.01 * sqrt(9.0 / 4 + 1.0 / 4 + 1.0 / 9 + 1.0 / 64), 1e-12);
    CHECK_NEAR(e.tip_sigma, 0.01, 1e-12);
    // the slope at the end of the parabola through the last three: (3, -4, 1) / (2 h), h = 1/4
    CHECK_NEAR(e.tip_angle_sigma, 0.01 * sqrt(26) * 2, 1e-12);
    l.measured.correlation_length = 1e12; // all go together
    e = error_of(&l, at_rest);
    CHECK_NEAR(e.shape_sigma, 0.01 * 59.0 / 24, 1e-10);
    l.measured.correlation_length = 0.25 / log(2.0); // 1/2 from station to station
    e = error_of(&l, at_rest);
    // 2 (a1 a2/2 + a2 a3/2 + a3 a4/2 + a1 a3/4 + a2 a4/4 + a1 a4/8), a = 3/2, 1/2, 1/3, 1/8
    const double cross = 3.0 / 4 + 1.0 / 6 + 1.0 / 24 + 1.0 / 4 + 1.0 / 32 + 3.0 / 64;
    CHECK_NEAR(e.shape_sigma, 0.01 * sqrt(9.0 / 4 + 1.0 / 4 + 1.0 / 9 + 1.0 / 64 + cross), 1e-12);
    centreline_free(&l.measured);
}

static void a_line_that_is_the_model(void)
{
    static lines l;
    static double s[101];
    for (int i = 0; i <= 100; i++) {
        s[i] = i / 100.0;
    }
    model_of(&l, 101, 1, arc_x);
    measured_at(&l, 101, s, arc_x);
    const shape_error e = error_of(&l, at_rest);
    CHECK_WITHIN(e.shape, 0, 1e-7); // two interpolations of one arc
    CHECK_WITHIN(e.tip, 0, 1e-15);
    CHECK_WITHIN(e.tip_angle, 0, 1e-7);
    centreline_free(&l.measured);
}

// An arc's bend is about the normal of its plane, 2 everywhere; ends have no whole window
static void the_bend_of_an_arc(void)
{
    static lines l;
    static double s[201], sigma[201];
    static vec3 bend[201];
    for (int i = 0; i <= 200; i++) {
        s[i] = i / 200.0;
    }
    measured_at(&l, 201, s, arc_x);
    for (int i = 0; i <= 200; i++) {
        l.measured.sigma[i] = 1e-4;
    }
    centreline_bend(&l.measured, 0.1, bend, sigma);
    CHECK(isnan(bend[0].a[1]) && isnan(bend[200].a[1]) && isnan(bend[5].a[1]));
    for (int i = 20; i <= 180; i += 20) {
        CHECK_NEAR(bend[i].a[1], 2, 5e-3); // (window/2)^2 kappa^2 / 10 off
        CHECK_WITHIN(bend[i].a[0], 0, 1e-9);
    }
    // second derivative of a parabola by least squares over n equal steps h: sigma sqrt(720 / n^5)
    // / h^2 for many
    CHECK_NEAR(sigma[100], 1e-4 * sqrt(720 / pow(21, 5)) * 4e4, 0.02);
    centreline_free(&l.measured);
}

int main(void)
{
    two_straight_lines();
    the_stored_example();
    two_arcs();
    a_line_that_misses_the_base();
    a_part_of_the_rod();
    arclength_as_it_lies();
    uncertainty_of_the_shape_error();
    a_line_that_is_the_model();
    the_bend_of_an_arc();
    return test_failures != 0;
}
