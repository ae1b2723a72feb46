// The figures' and the views' colours as colour-blind eyes see them.
#include "reports/palette.h"
#include "tests/test.h"
#include "tests/unit/reports/colour_vision.h"

// CIEDE2000. The eight colours of Okabe and Ito (2008), which many journals ask for, are 10.9 apart
// at least under the same four kinds of eyes.
static const double apart = 13, first_apart = 20;

// pairs 1, 17 to 20 and 25 of the paper's table, its four decimals
static void the_difference_is_the_published_one(void)
{
    static const struct {
        lab p, q;
        double wanted;
    } rows[] = {
        {{50, 2.6772, -79.7751}, {50, 0, -82.7485}, 2.0425},
        {{50, 2.5, 0}, {73, 25, -18}, 27.1492},
        {{50, 2.5, 0}, {61, -5, 29}, 22.8977},
        {{50, 2.5, 0}, {56, -27, -3}, 31.9030},
        {{50, 2.5, 0}, {58, 24, 15}, 19.4535},
        {{60.2574, -34.0099, 36.2677}, {60.4626, -34.1751, 39.4387}, 1.2644},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        CHECK_NEAR(colour_difference(rows[i].p, rows[i].q), rows[i].wanted, 1e-4);
        CHECK_NEAR(colour_difference(rows[i].q, rows[i].p), rows[i].wanted, 1e-4);
    }
    const lab white = lab_of((colour){1, 1, 1, 1}, NORMAL);
    CHECK_NEAR(white.L, 100, 1e-3);
    CHECK(hypot(white.a, white.b) < 0.02);
}

// red and green of one lightness: what the simulation is for
static void a_palette_of_red_and_green_would_fail(void)
{
    const colour red = {0.75, 0.25, 0.2, 1}, green = {0.37, 0.48, 0.1, 1};
    CHECK(colour_difference(lab_of(red, NORMAL), lab_of(green, NORMAL)) > 40);
    CHECK(colour_difference(lab_of(red, DEUTANOPIA), lab_of(green, DEUTANOPIA)) < first_apart);
}

static double least_apart(int n, const colour *inks)
{
    double least = INFINITY;
    for (int v = 0; v < VISIONS; v++) {
        for (int i = 0; i < n; i++) {
            for (int k = 0; k < i; k++) {
                least = fmin(least, colour_difference(lab_of(inks[i], (vision)v),
                                                      lab_of(inks[k], (vision)v)));
            }
        }
    }
    return least;
}

static void told_apart(const char *what, int n, const colour *inks, double least)
{
    const double found = least_apart(n, inks);
    printf("%-36s %d colours, %.1f apart at least\n", what, n, found);
    CHECK(found >= least);
}

static void categories_are_told_apart(void)
{
    colour material[PALETTE_SIZE], series[PALETTE_SIZE], bar[3];
    for (int i = 0; i < PALETTE_SIZE; i++) {
        material[i] = colour_material(i);
        series[i] = colour_series(i);
    }
    for (int i = 0; i < 3; i++) {
        bar[i] = colour_mix(colour_series(i), PAPER, 0.25);
    }
    told_apart("materials", PALETTE_SIZE, material, apart);
    told_apart("the first materials", 3, material, first_apart);
    told_apart("lines", PALETTE_SIZE, series, apart);
    told_apart("the first lines", 3, series, first_apart);
    told_apart("bars of a tornado", 3, bar, apart);
    told_apart("reached or not", 3, (const colour[]){REACH_YES, REACH_NO, REACH_OPEN}, first_apart);
    told_apart("the wall", 3, (const colour[]){WALL_YES, WALL_NO, WALL_OPEN}, first_apart);
    told_apart("beside the tissue", 4, (const colour[]){REACH_YES, REACH_NO, REACH_OPEN, TISSUE},
               apart);
    told_apart("targets", 2, (const colour[]){REACH_YES, INK_ACCENT}, first_apart);
    told_apart("loads", 2, (const colour[]){INK, LOAD_FOLLOWER}, apart);
    told_apart("inks", 3, (const colour[]){INK, INK_ACCENT, INK_SECOND}, first_apart);
    told_apart("a scan", 3, (const colour[]){CLOUD_POINT, CLOUD_TUBE, INK_ACCENT}, first_apart);
}

// six steps of the ramp, too little room and not looked at: clearance along a body. Of steps that
// follow each other the lightness tells the order
static void what_stands_beside_the_ramp_is_none_of_it(void)
{
    for (int i = 0; i < 6; i++) {
        const colour step = colour_ramp(i / 5.0);
        CHECK(least_apart(2, (const colour[]){step, INK_ACCENT}) >= apart);
        CHECK(least_apart(2, (const colour[]){step, NOT_LOOKED_AT}) >= apart);
    }
    CHECK(least_apart(2, (const colour[]){INK_ACCENT, NOT_LOOKED_AT}) >= apart);
}

enum { STEPS = 40 };
static const double uneven = 0.3; // of the mean step

// lightness rises all the way, and equal differences of the number are equal differences of colour
static void ramp_is_even(const char *what, colour from, colour to, bool ramp)
{
    for (int v = 0; v < VISIONS; v++) {
        double step[STEPS], sum = 0, least = INFINITY, most = 0;
        int rising = 0;
        for (int i = 0; i < STEPS; i++) {
            const double t[2] = {(double)i / STEPS, (i + 1.0) / STEPS};
            const lab p = lab_of(ramp ? colour_ramp(t[0]) : colour_mix(from, to, t[0]), (vision)v);
            const lab q = lab_of(ramp ? colour_ramp(t[1]) : colour_mix(from, to, t[1]), (vision)v);
            rising += q.L > p.L ? 1 : -1;
            sum += step[i] = colour_difference(p, q);
        }
        for (int i = 0; i < STEPS; i++) {
            least = fmin(least, step[i] * STEPS / sum);
            most = fmax(most, step[i] * STEPS / sum);
        }
        printf("%-12s eyes %d: %5.1f long, steps %.2f to %.2f of their mean\n", what, v, sum, least,
               most);
        CHECK(rising == STEPS || rising == -STEPS);
        CHECK(least >= 1 - uneven && most <= 1 + uneven);
    }
}

static void ramps_are_even(void)
{
    ramp_is_even("ramp", PAPER, PAPER, true);
    ramp_is_even("tissue", TISSUE_PALE, TISSUE_DEEP, false);
    CHECK(lab_of(colour_ramp(1), NORMAL).L - lab_of(colour_ramp(0), NORMAL).L > 60);
    CHECK(colour_ramp(-3).g == colour_ramp(0).g && colour_ramp(NAN).g == colour_ramp(0).g);
}

int main(void)
{
    the_difference_is_the_published_one();
    a_palette_of_red_and_green_would_fail();
    categories_are_told_apart();
    what_stands_beside_the_ramp_is_none_of_it();
    ramps_are_even();
    return test_failures != 0;
}
