// tests/unit/base/test_field_table.c
#include "base/field_table.h"
#include "tests/test.h"

#include <string.h>

static const double ROUNDING = 1e-14;

static field_table table_of(int along, int n, double *places, double *values)
{
    return (field_table){.at = {1, 1},
                         .along = along,
                         .places = {.at = {4, 9}, .nrow = 1, .ncol = n, .a = places},
                         .values = {.at = {5, 9}, .nrow = n, .ncol = 1, .a = values}};
}

static double at_x(const field_table *t, double x)
{
    const place_field f = field_table_place(t);
    return place_field_at(&f, x, 77);
}

static void entries_are_met_and_a_straight_line_stays_one(void)
{
    double x[] = {-2, -1, 0.5, 3}, y[] = {1, 3, 6, 11};
    const field_table t = table_of(TABLE_ALONG_X, 4, x, y);
    CHECK_OK(field_table_check(&t));
    for (int i = 0; i < 4; i++) {
        CHECK_NEAR(at_x(&t, x[i]), y[i], ROUNDING);
    }
    for (double u = -2; u <= 3; u += 0.1) {
        CHECK_NEAR(at_x(&t, u), 5 + 2 * u, ROUNDING);
    }
    CHECK_NEAR(at_x(&t, -9), 1, ROUNDING); // beyond the ends
    CHECK_NEAR(at_x(&t, 9), 11, ROUNDING);
}

static void what_only_rises_stays_within_its_entries(void)
{
    double x[] = {0, 1, 2, 3, 4}, y[] = {1, 1, 1.001, 9, 9};
    const field_table t = table_of(TABLE_ALONG_X, 5, x, y);
    double before = 1;
    for (int i = 0; i <= 4000; i++) {
        const double now = at_x(&t, 1e-3 * i);
        CHECK(now >= before - ROUNDING * 9 && now >= 1 - ROUNDING && now <= 9 + ROUNDING * 9);
        before = now;
    }
}

// a smooth function: twice the entries, at least an eighth of the error
static void more_entries_come_nearer_to_a_smooth_function(void)
{
    double h[2], error[2] = {0};
    for (int k = 0; k < 2; k++) {
        double x[41], y[41];
        const int n = k == 0 ? 21 : 41;
        for (int i = 0; i < n; i++) {
            x[i] = 1.0 * i / (n - 1);
            y[i] = exp(x[i]);
        }
        const field_table t = table_of(TABLE_ALONG_X, n, x, y);
        h[k] = x[1];
        for (int i = 0; i <= 1000; i++) {
            error[k] = fmax(error[k], fabs(at_x(&t, 1e-3 * i) - exp(1e-3 * i)));
        }
    }
    CHECK_NEAR(observed_order(2, h, error), 3, 0.2);
}

static void a_table_runs_over_the_coordinate_it_names(void)
{
    double x[] = {0, 1}, y[] = {1, 2};
    const field_table over_y = table_of(TABLE_ALONG_Y, 2, x, y);
    const field_table over_s = table_of(TABLE_ALONG_S, 2, x, y);
    place_field f = field_table_place(&over_y);
    CHECK_NEAR(place_field_at(&f, 0.9, 0.25), 1.25, ROUNDING);
    CHECK(f.across && !f.along);
    f = field_table_place(&over_s);
    f.s = 0.75;
    CHECK_NEAR(place_field_at(&f, 0.9, 0.25), 1.75, ROUNDING);
    CHECK(!f.across && f.along);
}

static void check_refused(const field_table *t, int want_line, const char *words)
{
    int line = 0, column = 0;
    CHECK(field_table_check(t) == ERR_INPUT);
    CHECK(status_place(&line, &column) && line == want_line && column == 9);
    CHECK(strstr(status_message(), words));
    status_clear();
}

static void tables_that_are_none_are_refused(void)
{
    double x[] = {0, 1e-3, 1e-3}, y[] = {1, 2, 3};
    field_table t = table_of(TABLE_ALONG_X, 3, x, y);
    check_refused(&t, 4, "must ascend: entry 3 is 1 mm after 1 mm");
    t.values.nrow = 2;
    check_refused(&t, 5, "a table of 3 places needs as many values, found 2");
    t.places.ncol = 1;
    check_refused(&t, 4, "two places or more, found 1");
}

int main(void)
{
    entries_are_met_and_a_straight_line_stays_one();
    what_only_rises_stays_within_its_entries();
    more_entries_come_nearer_to_a_smooth_function();
    a_table_runs_over_the_coordinate_it_names();
    tables_that_are_none_are_refused();
    return test_failures != 0;
}
