// tests/unit/reports/test_figure_kit.c
#include "reports/figure_kit.h"
#include "tests/test.h"

#include <string.h>

static int reads(number_text number, const char *wanted)
{
    if (strcmp(number.text, wanted) != 0) {
        printf("'%s' instead of '%s'\n", number.text, wanted);
    }
    return strcmp(number.text, wanted) == 0;
}

static void numbers_are_written_as_in_print(void)
{
    CHECK(reads(number_digits(29.213042, 6), "29.2130"));
    CHECK(reads(number_digits(-0.00212334, 4), "−0.002123"));
    CHECK(reads(number_digits(0, 5), "0"));
    CHECK(reads(number_digits(1000, 4), "1000"));
    CHECK(reads(number_digits(123456, 3), "123456")); // never fewer digits than the number has
    CHECK(reads(number_digits(1.25e-8, 2), "1.2×10⁻⁸"));
    CHECK(reads(number_digits(-6.02e23, 3), "−6.02×10²³"));
    CHECK(reads(number_digits(NAN, 3), "not finite"));
    CHECK(reads(number_short(0.5, 3), "0.5"));
    CHECK(reads(number_short(20, 4), "20"));
    CHECK(reads(number_short(15.93, 5), "15.93"));
    CHECK(reads(number_fixed(-1e-9, 3), "0.000"));
    CHECK(reads(number_fixed(-0.0005001, 3), "−0.001"));
    CHECK(reads(number_fixed(226.04, 1), "226.0"));
    CHECK(reads(number_fixed(INFINITY, 1), "not finite"));
}

static void steps_are_round(void)
{
    CHECK_NEAR(nice_step(120, 6), 20, 1e-14);
    CHECK_NEAR(nice_step(0.037, 5), 0.01, 1e-14);
    CHECK_NEAR(nice_step(1, 1), 1, 1e-14);
    CHECK_NEAR(nice_step(9, 1), 10, 1e-14);
    CHECK_NEAR(nice_step(0, 5), 1, 0);
    for (double span = 1e-6; span < 1e6; span *= 1.37) {
        const double steps = span / nice_step(span, 5);
        CHECK(steps > 5 / 1.6 && steps < 5 * 1.6);
    }
}

// CIE relative luminance of an sRGB colour
static double luminance(colour c)
{
    const double part[3] = {c.r, c.g, c.b}, weight[3] = {0.2126, 0.7152, 0.0722};
    double sum = 0;
    for (int i = 0; i < 3; i++) {
        sum += weight[i] *
               (part[i] <= 0.04045 ? part[i] / 12.92 : pow((part[i] + 0.055) / 1.055, 2.4));
    }
    return sum;
}

// so that it reads in grey print and with any colour vision
static void the_ramp_gets_lighter_all_the_way(void)
{
    for (int i = 0; i < 100; i++) {
        CHECK(luminance(colour_ramp((i + 1) / 100.0)) > luminance(colour_ramp(i / 100.0)));
    }
    CHECK(luminance(colour_ramp(1)) > 10 * luminance(colour_ramp(0)));
    CHECK(luminance(colour_ramp(-3)) == luminance(colour_ramp(0)));
}

static double contrast(colour a, colour b)
{
    const double la = luminance(a) + 0.05, lb = luminance(b) + 0.05;
    return la > lb ? la / lb : lb / la;
}

// WCAG 2.1: 4.5 for text on white, 3 for lines; the two materials that a case has most often differ
// in grey
static void inks_stand_out(void)
{
    const colour white = {1, 1, 1, 1};
    CHECK(contrast(LOOK_TEXT.ink, white) > 7);
    CHECK(contrast(LOOK_SMALL.ink, white) > 4.5);
    CHECK(contrast(LOOK_TICK.ink, white) > 4.5);
    CHECK(contrast(INK_ACCENT, white) > 4.5);
    CHECK(contrast(INK_SECOND, white) > 4.5);
    for (int i = 0; i < 6; i++) {
        CHECK(contrast(colour_series(i), white) > 2.5);
    }
    CHECK(contrast(colour_material(0), colour_material(1)) > 1.5);
}

static void axes_map_both_ends(void)
{
    const plot p = {{10, 20, 100, 50}, -1, 3, 0, 5};
    CHECK_NEAR(plot_x(&p, -1), 10, 1e-14);
    CHECK_NEAR(plot_x(&p, 3), 110, 1e-14);
    CHECK_NEAR(plot_y(&p, 0), 70, 1e-14);
    CHECK_NEAR(plot_y(&p, 5), 20, 1e-14);
    double low = 2, high = 2;
    range_pad(&low, &high, 0.25, 4);
    CHECK_NEAR(low, -1, 1e-14);
    CHECK_NEAR(high, 5, 1e-14);
}

int main(void)
{
    numbers_are_written_as_in_print();
    steps_are_round();
    the_ramp_gets_lighter_all_the_way();
    inks_stand_out();
    axes_map_both_ends();
    return test_failures != 0;
}
