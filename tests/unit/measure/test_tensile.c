// tests/unit/measure/test_tensile.c
#include "measure/tensile.h"
#include "tests/test.h"

#include <string.h>

enum { POINTS = 300 };

static const double modulus = 2e6, top = 0.06;

// a straight line with a little of a wave that no fit can follow; synthetic
static tensile_curve straight(void)
{
    tensile_curve c = {0};
    CHECK_OK(tensile_curve_make(POINTS, &c));
    for (int i = 0; i < POINTS; i++) {
        c.strain[i] = top * i / (POINTS - 1);
        c.stress[i] = modulus * (c.strain[i] + 1e-5 * sin(7.0 * i * i));
    }
    return c;
}

static tensile_answer measured(const tensile_curve *c)
{
    const tensile_rule rule = tensile_rule_default();
    tensile_answer a = {0};
    CHECK_OK(tensile_measure(c, &rule, &a));
    return a;
}

static bool holds(const tensile_answer *a, double E)
{
    return a->interval[0] <= E && E <= a->interval[1];
}

static void a_straight_line_is_linear_to_its_end(void)
{
    tensile_curve c = straight();
    const tensile_answer a = measured(&c);
    CHECK(holds(&a, modulus));
    CHECK_NEAR(a.E, modulus,
               0.003); // the wave is 5e-4 of half the stress, over some hundred points
    CHECK(a.linear_to_end && !a.unloads && a.nspike == 0 && a.nduplicate == 0);
    CHECK_NEAR(a.linear_strain, top, 0.01);
    CHECK_WITHIN(a.strain_offset, 0, 1e-4);
    tensile_curve_free(&c);
}

// units move E and the strains as they must, and nothing else: powers of two, which do not round
static void scales_pass_through(void)
{
    tensile_curve c = straight();
    const tensile_answer a = measured(&c);
    for (int i = 0; i < c.n; i++) {
        c.strain[i] = 0.5 * c.strain[i];
        c.stress[i] *= 1024;
    }
    const tensile_answer b = measured(&c);
    CHECK_NEAR(b.E, 2048 * a.E, 1e-9); // rounding of a least-squares solution
    CHECK_NEAR(b.standard_error, 2048 * a.standard_error, 1e-6);
    CHECK_NEAR(b.strain_offset, 0.5 * a.strain_offset, 1e-9);
    tensile_curve_free(&c);
}

static void compression_gives_the_same_modulus(void)
{
    tensile_curve c = straight();
    const tensile_answer a = measured(&c);
    for (int i = 0; i < c.n; i++) {
        c.strain[i] = -c.strain[i];
        c.stress[i] = -c.stress[i];
    }
    const tensile_answer b = measured(&c);
    CHECK(b.turned && !a.turned && b.E == a.E);
    tensile_curve_free(&c);
}

static void duplicates_and_spikes_are_left_out(void)
{
    tensile_curve c = straight(), d = {0};
    const tensile_answer a = measured(&c);
    CHECK_OK(tensile_curve_make(2 * POINTS, &d));
    for (int i = 0; i < 2 * POINTS; i++) {
        d.strain[i] = c.strain[i / 2];
        d.stress[i] = c.stress[i / 2];
    }
    const tensile_answer twice = measured(&d);
    CHECK(twice.nduplicate == POINTS && twice.E == a.E);
    CHECK(twice.standard_error == a.standard_error);
    c.stress[150] *= 3;
    const tensile_answer spiked = measured(&c);
    CHECK(spiked.nspike == 1 && holds(&spiked, modulus));
    tensile_curve_free(&c);
    tensile_curve_free(&d);
}

static void a_slip_ends_the_curve(void)
{
    tensile_curve c = straight();
    for (int i = 200; i < c.n; i++) {
        c.stress[i] -= 0.1 * modulus * top;
    }
    const tensile_answer a = measured(&c);
    CHECK_NEAR(a.slip, c.strain[200], 0.02);
    CHECK(a.nloading <= 200 && holds(&a, modulus));
    tensile_curve_free(&c);
}

static void only_the_first_loading_counts(void)
{
    tensile_curve c = {0};
    CHECK_OK(tensile_curve_make(3 * POINTS, &c));
    for (int i = 0; i < c.n; i++) {
        const double phase = fmod((double)i / POINTS, 2);
        const bool first = i < POINTS; // softer from then on
        c.strain[i] = top * (phase > 1 ? 2 - phase : phase);
        c.stress[i] = (first ? 1 : 0.5) * modulus * (c.strain[i] + 1e-5 * sin(7.0 * i * i));
    }
    const tensile_answer a = measured(&c);
    CHECK(a.unloads && holds(&a, modulus));
    CHECK(a.nloading > POINTS - 10 && a.nloading <= POINTS + 1);
    tensile_curve_free(&c);
}

static void a_knee_is_the_end_of_the_linear_range(void)
{
    tensile_curve c = straight();
    for (int i = 0; i < c.n; i++) {
        const double over = c.strain[i] - 0.03;
        c.stress[i] -= over > 0 ? 0.5 * modulus * over : 0;
    }
    const tensile_answer a = measured(&c);
    // half the slope beyond 3 %: the stress is 5 % off the line where 0.5 (x - 3) = 0.05 x
    CHECK(!a.linear_to_end);
    CHECK_NEAR(a.linear_strain, 0.03 / 0.9, 0.05); // neighbours' means are 2 % of the strain
    tensile_curve_free(&c);
}

// neo-Hookean in tension: sigma/E = (lambda - 1/lambda^2)/3
static double neo(double strain)
{
    const double stretch = 1 + strain;
    return (stretch - 1 / (stretch * stretch)) / 3;
}

// Where a line of slope `line` times the first one leaves it by that share, the line's zero being
// `ahead` in front of the curve's; by halving
static double neo_leaves_at(double line, double ahead, double departure)
{
    double low = 0.02, high = 1;
    for (int i = 0; i < 60; i++) {
        const double middle = 0.5 * (low + high);
        if (neo(middle - ahead) > (1 - departure) * line * middle) {
            low = middle;
        } else {
            high = middle;
        }
    }
    return low;
}

// with hardly any noise, which does not hide any bend, to 12 % and to 24 %; with a slack of 1 % in
// front the strain counts from there
static void linear_strain_belongs_to_E(void)
{
    enum { MANY = 1200 };
    for (int k = 0; k < 4; k++) {
        const double most = k % 2 ? 0.24 : 0.12, slack = k < 2 ? 0 : 0.01;
        tensile_curve c = {0};
        CHECK_OK(tensile_curve_make(MANY, &c));
        for (int i = 0; i < MANY; i++) {
            c.strain[i] = most * i / (MANY - 1);
            c.stress[i] = modulus * (neo(fmax(c.strain[i] - slack, 0)) + 1e-5 * sin(7.0 * i * i));
        }
        const tensile_answer a = measured(&c);
        const double line = a.E / modulus;
        CHECK(!a.linear_to_end);
        CHECK_WITHIN(a.E, modulus, a.interval[1] - a.interval[0]);
        // of the line that is told, to a half of the neighbours that are averaged
        CHECK_WITHIN(a.linear_strain, neo_leaves_at(line, slack - a.strain_offset, 0.05),
                     0.01 * most);
        // of the material: what E is off moves the end by 1/0.05 times as much
        CHECK_NEAR(a.linear_strain, neo_leaves_at(1, 0, 0.05), fabs(line - 1) / 0.05 + 0.03);
        tensile_curve_free(&c);
    }
}

// two samples of one rubber, E told 2 % too high and too low: their mean is right, and so is how
// far its line holds, which neither of their own does
static void pooled_linear_strain_belongs_to_pooled_E(void)
{
    const tensile_rule rule = tensile_rule_default();
    const bool used[2] = {true, true};
    tensile_curve c = straight();
    for (int i = 0; i < c.n; i++) {
        c.strain[i] *= 2;
        c.stress[i] = modulus * neo(c.strain[i]);
    }
    tensile_answer two[2] = {{.E = 1.02 * modulus,
                              .standard_error = 0.04 * modulus,
                              .correlation = 1,
                              .window = {0.001, 0.02},
                              .nwindow = 20,
                              .end = 2 * top}};
    two[1] = two[0];
    two[1].E = 0.98 * modulus;
    tensile_pool p = {0};
    CHECK_OK(tensile_pool_of(2, two, used, &rule, &p));
    CHECK_OK(tensile_pool_linear(2, (const tensile_curve *const[]){&c, &c}, two, used, &rule, &p));
    CHECK_NEAR(p.E, modulus, 1e-9);
    CHECK_WITHIN(p.linear_strain, neo_leaves_at(1, 0, 0.05), 0.01 * 2 * top); // half a bin
    CHECK(neo_leaves_at(1.02, 0, 0.05) < 0.9 * p.linear_strain);              // its own is another
    tensile_curve_free(&c);
}

static void hopeless_curves_are_refused(void)
{
    const tensile_rule rule = tensile_rule_default();
    tensile_answer a = {0};
    tensile_curve c = straight();
    c.n = 5;
    CHECK(tensile_measure(&c, &rule, &a) == ERR_FILE);
    CHECK(strstr(status_message(), "5 points of a first loading"));
    status_clear();
    c.n = 0;
    CHECK(tensile_measure(&c, &rule, &a) == ERR_FILE);
    status_clear();
    c.n = POINTS;
    for (int i = 0; i < c.n; i++) {
        c.stress[i] = 0;
    }
    CHECK(tensile_measure(&c, &rule, &a) == ERR_FILE);
    status_clear();
    tensile_curve_free(&c);
}

// weights 1 and 1/4 without scatter between: (10 + 12/4)/(5/4) = 10.4, and one degree of freedom
static void two_curves_are_weighted(void)
{
    const tensile_rule rule = tensile_rule_default();
    const tensile_answer two[] = {{.E = 10, .standard_error = 1, .linear_strain = 0.1},
                                  {.E = 12, .standard_error = 2, .linear_strain = 0.2}};
    const bool used[] = {true, true};
    tensile_pool p = {0};
    CHECK_OK(tensile_pool_of(2, two, used, &rule, &p));
    CHECK_NEAR(p.E, 10.4, 1e-12);
    CHECK(p.between == 0 && p.freedom == 1 && p.linear_strain == 0.1);
    CHECK_NEAR(p.standard_error, sqrt(0.8), 1e-12);
    // t of one degree of freedom: tan(pi/2 * 0.95)
    CHECK_NEAR(p.interval[1] - p.E, sqrt(0.8) * tan(acos(0.0) * 0.95), 1e-9);
}

// equal errors: mean and variance of a sample, the scatter between is that without the errors
static void scatter_between_samples_is_found(void)
{
    const tensile_rule rule = tensile_rule_default();
    tensile_answer a[5] = {{0}};
    bool used[5], outlier[5];
    tensile_pool p = {0};
    const double E[5] = {8, 9, 10, 11, 12}; // variance 2.5
    for (int i = 0; i < 5; i++) {
        a[i] = (tensile_answer){.E = E[i], .standard_error = 0.5, .linear_strain = 0.01 * (i + 1)};
        used[i] = true;
    }
    CHECK_OK(tensile_pool_of(5, a, used, &rule, &p));
    CHECK_NEAR(p.E, 10, 1e-12);
    CHECK_NEAR(p.between, sqrt(2.5 - 0.25), 1e-9);
    CHECK_NEAR(p.standard_error, sqrt(2.5 / 5), 1e-9);
    CHECK_NEAR(p.linear_strain, 0.03, 1e-12);
    CHECK_OK(tensile_outliers(5, a, outlier));
    for (int i = 0; i < 5; i++) {
        CHECK(!outlier[i]);
    }
    a[4].E = 20; // G = 1.70 of the sample against 1.715: not yet; 30 is
    CHECK_OK(tensile_outliers(5, a, outlier));
    const double mean = 58.0 / 5;
    double square = 0;
    for (int i = 0; i < 5; i++) {
        square += (a[i].E - mean) * (a[i].E - mean) / 4;
    }
    // Grubbs's table for five at 5 %, two-sided: 1.715
    CHECK(outlier[4] == ((20 - mean) / sqrt(square) > 1.715));
    a[4].E = 30;
    CHECK_OK(tensile_outliers(5, a, outlier));
    CHECK(outlier[4] && !outlier[0] && !outlier[3]);
}

int main(void)
{
    a_straight_line_is_linear_to_its_end();
    scales_pass_through();
    compression_gives_the_same_modulus();
    duplicates_and_spikes_are_left_out();
    a_slip_ends_the_curve();
    only_the_first_loading_counts();
    a_knee_is_the_end_of_the_linear_range();
    linear_strain_belongs_to_E();
    pooled_linear_strain_belongs_to_pooled_E();
    hopeless_curves_are_refused();
    two_curves_are_weighted();
    scatter_between_samples_is_found();
    return test_failures != 0;
}
