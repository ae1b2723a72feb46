// tests/unit/rodsolver/test_tendon_table.c
// Tendons given by points: the curve through them, the curve near noisy ones, and tables that are
// none.
#include "rodsolver/kinks.h"
#include "rodsolver/routing.h"
#include "rodsolver/tendon_table.h"
#include "tests/unit/rodsolver/prototypes.h"

#include "base/memory.h"

#include <string.h>

static const double length = 0.12, radius = 3.6e-3, turns = 3;

// a helix of `turns` turns
static void helix_at(double s, double place[2], double slope[2])
{
    const double rate = 2 * PROTOTYPE_PI * turns / length;
    place[0] = radius * cos(rate * s);
    place[1] = radius * sin(rate * s);
    slope[0] = -rate * place[1];
    slope[1] = rate * place[0];
}

// the sum of twelve uniform numbers, less six: normal enough, of variance 1
static double noise(unsigned long *seed)
{
    double sum = -6;
    for (int i = 0; i < 12; i++) {
        *seed = (*seed * 6364136223846793005UL + 1442695040888963407UL) & 0xffffffffffffffffUL;
        sum += (double)(*seed >> 11) / 9007199254740992.0;
    }
    return sum;
}

static double *helix_table(int n, double sigma)
{
    double *p = NULL;
    unsigned long seed = 1;
    CHECK_OK(TAKE(p, 3 * (size_t)n));
    for (int i = 0; i < n; i++) {
        double slope[2];
        p[3 * i] = length * i / (n - 1);
        helix_at(p[3 * i], p + 3 * i + 1, slope);
        p[3 * i + 1] += sigma * noise(&seed);
        p[3 * i + 2] += sigma * noise(&seed);
    }
    return p;
}

static tendon_spec with_table(int n, const double *point, double smooth)
{
    return (tendon_spec){.name = "t",
                         .radius = field_constant(0),
                         .end = length,
                         .table = {.count = n, .point = point, .smooth = smooth}};
}

// largest error of place and slope between the points
static void helix_error(const spline *path, double *place, double *slope)
{
    *place = *slope = 0;
    for (int i = 0; i <= 1000; i++) {
        double exact[2], rate[2], at[2], d[2];
        helix_at(length * i / 1000, exact, rate);
        spline_at(path, length * i / 1000, at, d);
        *place = fmax(*place, hypot(at[0] - exact[0], at[1] - exact[1]));
        *slope = fmax(*slope, hypot(d[0] - rate[0], d[1] - rate[1]));
    }
}

// degree 7: order 8 in the points' distance, 7 for the slope
static void points_of_a_helix_give_it_back(void)
{
    double h[3], place[3], slope[3];
    for (int i = 0; i < 3; i++) {
        const int n = (20 << i) + 1;
        double *p = helix_table(n, 0);
        const tendon_spec t = with_table(n, p, 0);
        spline path = {0};
        CHECK_OK(tendon_table_fit(&t, &path));
        CHECK(path.degree == 7);
        helix_error(&path, &place[i], &slope[i]);
        h[i] = 1.0 / (n - 1);
        for (int k = 0; k < n; k++) { // through the points
            double at[2], d[2];
            spline_at(&path, p[3 * k], at, d);
            CHECK(hypot(at[0] - p[3 * k + 1], at[1] - p[3 * k + 2]) < 1e-13 * radius);
        }
        printf("%3d points of a helix: off by %.1e m, slope %.1e\n", n, place[i], slope[i]);
        spline_free(&path);
        free(p);
    }
    CHECK(observed_order(3, h, place) > 7.5);
    CHECK(observed_order(3, h, slope) > 6.5);
    CHECK(place[2] < 1e-9); // what a rod is usually asked for
}

// polynomials up to the degree come back exactly, with fields added
static void few_points_are_a_polynomial(void)
{
    static const double point[4][3] = {
        {0, 1e-3, 2e-3}, {0.02, 1.5e-3, 2e-3}, {0.07, 0, -1e-3}, {0.12, 2e-3, 0}};
    for (int n = 2; n <= 4; n++) {
        double p[12];
        memcpy(p, point, sizeof p);
        p[3 * (n - 1)] = length;
        tendon_spec t = with_table(n, p, 0);
        spline path = {0};
        t.x = field_constant(1e-3);
        CHECK_OK(tendon_table_fit(&t, &path));
        CHECK(path.degree == n - 1 && path.ncoef == n);
        routing r;
        routing_make(&t, &path, 0.01, 0.03, &r);
        // Lagrange's form
        double x = 1e-3, y = 0;
        for (int i = 0; i < n; i++) {
            double part = 1;
            for (int j = 0; j < n; j++) {
                part *= i == j ? 1 : (0.025 - p[3 * j]) / (p[3 * i] - p[3 * j]);
            }
            x += part * p[3 * i + 1];
            y += part * p[3 * i + 2];
        }
        const tendon_place q = routing_at(&r, 0.025);
        CHECK_NEAR(q.x, x, 1e-12);
        CHECK_NEAR(q.y, y, 1e-12);
        spline_free(&path);
    }
}

// Least squares of p coefficients leave sigma^2 p / n of the noise in the mean, and the simplest
// curve that is near enough has no more bias than that: between 0.5 and 2 of it all in all.
static void noise_is_smoothed_as_theory_says(void)
{
    const double sigma = 20e-6;
    for (int n = 200; n <= 20000; n *= 10) {
        double *p = helix_table(n, sigma);
        const tendon_spec t = with_table(n, p, sigma * sqrt(2)); // of distances in the plane
        spline path = {0};
        CHECK_OK(tendon_table_fit(&t, &path));
        double squares = 0;
        for (int i = 0; i < n; i++) {
            double exact[2], rate[2], at[2], d[2];
            helix_at(p[3 * i], exact, rate);
            spline_at(&path, p[3 * i], at, d);
            squares += pow(at[0] - exact[0], 2) + pow(at[1] - exact[1], 2);
        }
        const double theory = sqrt(2 * sigma * sigma * path.ncoef / n), rms = sqrt(squares / n);
        printf("%5d noisy points: %d coefficients, off by %.2e m rms, theory %.2e m\n", n,
               path.ncoef, rms, theory);
        CHECK(rms > 0.5 * theory && rms < 2 * theory);
        CHECK(path.ncoef < 40); // of three turns
        spline_free(&path);
        free(p);
    }
}

// the simplest curve: constants, straight lines
static void simple_paths_stay_simple(void)
{
    double p[90];
    unsigned long seed = 7;
    for (int degree = 0; degree <= 1; degree++) {
        for (int i = 0; i < 30; i++) {
            p[3 * i] = length * i / 29;
            p[3 * i + 1] = 3e-3 - degree * 0.01 * p[3 * i] + 1e-6 * noise(&seed);
            p[3 * i + 2] = 1e-3 + 1e-6 * noise(&seed);
        }
        const tendon_spec t = with_table(30, p, 2e-6);
        spline path = {0};
        CHECK_OK(tendon_table_fit(&t, &path));
        CHECK(path.degree == degree);
        spline_free(&path);
    }
}

// a tendon that runs straight between guides far apart: no wild swings, and knots become edges
static void corners_do_not_swing(void)
{
    double p[3 * 13];
    for (int i = 0; i < 13; i++) {
        p[3 * i] = length * i / 12;
        p[3 * i + 1] = i < 6 ? 1e-3 : -1e-3;
        p[3 * i + 2] = 0;
    }
    const tendon_spec t = with_table(13, p, 0);
    spline path = {0};
    double kink[MOST_KINKS];
    CHECK_OK(tendon_table_fit(&t, &path));
    CHECK(path.degree < 7);
    CHECK(tendon_table_kinks(&path, MOST_KINKS, kink) == path.ncoef - path.degree - 1);
    CHECK(tendon_table_kinks(&path, 2, kink) == 0);
    double most = 0;
    for (int i = 0; i <= 1000; i++) {
        double at[2], d[2];
        spline_at(&path, length * i / 1000, at, d);
        most = fmax(most, fabs(at[0]));
    }
    CHECK(most < 1.4e-3);
    spline_free(&path);
}

static void refused(tendon_spec t, const char *words)
{
    spline path = {0};
    CHECK(tendon_table_fit(&t, &path) == ERR_INPUT);
    CHECK(strstr(status_message(), words) != NULL);
    CHECK(path.coef == NULL);
    status_clear();
}

static void hostile_tables_are_refused(void)
{
    double p[12] = {0, 0, 0, 0.04, 1e-3, 0, 0.04, 1e-3, 0, 0.12, 0, 0};
    refused(with_table(1, p, 0), "two points");
    refused(with_table(-1, p, 0), "two points");
    refused(with_table(4, NULL, 0), "two points");
    refused(with_table(4, p, 0), "row 3 of its table does not lie beyond");
    refused(with_table(4, p, -1), "smoothed");
    refused(with_table(4, p, NAN), "smoothed");
    p[6] = 0.02;
    refused(with_table(4, p, 0), "row 3");
    p[6] = 0.08;
    p[7] = INFINITY;
    refused(with_table(4, p, 0), "row 3 of its table is not finite");
    p[7] = 0;
    p[9] = 0.1;
    refused(with_table(4, p, 0), "runs from s = 0 mm to 100 mm");
    p[9] = 0.12;
    p[0] = 0.01;
    refused(with_table(4, p, 0), "runs from s = 10 mm");
    tendon_spec t = with_table(4, p, NAN);
    t.at = (mark){7, 3};
    int line = 0, column = 0;
    spline path = {0};
    CHECK(tendon_table_fit(&t, &path) == ERR_INPUT);
    CHECK(status_place(&line, &column) && line == 7 && column == 3);
    status_clear();
}

// points a million times nearer to each other at one end than at the other, with digits cut off
static void uneven_points_stay_tame(void)
{
    double p[3 * 12];
    for (int i = 0; i < 12; i++) {
        p[3 * i] = i < 11 ? 1e-7 * i : length;
        p[3 * i + 1] = 1e-3 + (i % 2 ? 1e-9 : -1e-9);
        p[3 * i + 2] = 0;
    }
    tendon_spec t = with_table(12, p, 0);
    for (int smooth = 0; smooth < 2; smooth++) {
        spline path = {0};
        t.table.smooth = smooth * 1e-8;
        CHECK_OK(tendon_table_fit(&t, &path));
        double at[2], d[2];
        spline_at(&path, length / 2, at, d);
        CHECK(isfinite(at[0]));
        CHECK(!smooth || path.degree == 0);
        spline_free(&path);
    }
}

static double helix_angle(const void *unused, double s)
{
    (void)unused;
    return 2 * PROTOTYPE_PI * turns * s / length;
}

// the whole rod: a table of the helix against the helix itself, and the order of the quadrature
// with knots inside the panels
static void rods_follow_the_table(void)
{
    const prototype proto = helical_nc();
    law_along law = {0};
    prototype_law(&proto, &law);
    const int n = 241;
    double *p = helix_table(n, 0), tau = 0.7;
    tendon_spec t[2] = {straight_tendon("exact", radius, 0), straight_tendon("table", 0, 0)};
    t[0].angle = (field){.at = helix_angle};
    t[1].table = (tendon_table){.count = n, .point = p};
    rod_solution exact = {0}, tabled = {0};
    const rod_options options = {.tolerance = 1e-12};
    const made_rod a = solved_rod(&law, 1, &t[0], options, &tau, &exact);
    const made_rod b = solved_rod(&law, 1, &t[1], options, &tau, &tabled);
    CHECK(distance(exact.tip.p, tabled.tip.p) < 2e-12 * length);
    printf("241 points: tip off by %.1e m, %d panels, %d for the helix\n",
           distance(exact.tip.p, tabled.tip.p), rod_panel_count(b.state), rod_panel_count(a.state));
    CHECK(rod_panel_count(b.state) == rod_panel_count(a.state));
    double h[3], error[3];
    for (int i = 0; i < 3; i++) {
        rod_solution out = {0};
        h[i] = 1.0 / (16 << i);
        const made_rod m = solved_rod(&law, 1, &t[1], (rod_options){.npanel = 16 << i}, &tau, &out);
        error[i] = distance(out.tip.p, tabled.tip.p);
        free_rod(m);
    }
    CHECK(observed_order(3, h, error) > 5.7);
    free_rod(a);
    free_rod(b);
    free(p);
    law_along_free(&law);
}

// through all points, near them, and so near that it takes many pieces
static void long_tables_are_no_trouble(void)
{
    const int n[3] = {100000, 100000, 10000};
    const double smooth[3] = {0, 1.5e-6, 1e-6};
    for (int i = 0; i < 3; i++) {
        double *p = helix_table(n[i], 1e-6);
        const tendon_spec t = with_table(n[i], p, smooth[i]);
        spline path = {0};
        CHECK_OK(tendon_table_fit(&t, &path));
        spline_free(&path);
        free(p);
    }
}

int main(void)
{
    points_of_a_helix_give_it_back();
    few_points_are_a_polynomial();
    noise_is_smoothed_as_theory_says();
    simple_paths_stay_simple();
    corners_do_not_swing();
    hostile_tables_are_refused();
    uneven_points_stay_tame();
    rods_follow_the_table();
    long_tables_are_no_trouble();
    return test_failures != 0;
}
