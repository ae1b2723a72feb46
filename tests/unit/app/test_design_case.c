// tests/unit/app/test_design_case.c
#include "app/design_case.h"
#include "app/design_score.h"
#include "tests/test.h"

#include <string.h>

static void replaced(const char *text, const char *wanted)
{
    static const char *const name[] = {"a", "width", "e"};
    static const double value[] = {-1.5, 0.1, 7};
    char *out = NULL;
    CHECK_OK(design_words(text, 3, name, value, &out));
    if (!out || strcmp(out, wanted) != 0) {
        printf("'%s' became '%s', wanted '%s'\n", text, out ? out : "", wanted);
        test_failures++;
    }
    free(out);
}

static void names_become_numbers_and_nothing_else_does(void)
{
    replaced("a", "-1.5");
    replaced("2*a", "2*(-1.5)");
    replaced("2-a^2", "2-(-1.5)^2"); // what the parentheses are for
    replaced("pi - a*pi*s/L", "pi - (-1.5)*pi*s/L");
    replaced("tan(a) + abs(width)", "tan((-1.5)) + abs((0.10000000000000001))");
    replaced("widths + a_1 + _a", "widths + a_1 + _a");
    replaced("1e-3*e", "1e-3*(7)");
    replaced("2e", "2(7)"); // no number's exponent: what follows tells that it is nonsense
    replaced("1.5E+2a", "1.5E+2(-1.5)");
    replaced("[a, 0.5, {x: e}]", "[(-1.5), 0.5, {x: (7)}]");
    replaced("{a: a, 'width' : 2, x: {e: a}}", "{a: (-1.5), 'width' : 2, x: {e: (-1.5)}}");
    replaced("x > 0 ? a : e", "x > 0 ? (-1.5) : (7)");
    replaced("{x: 'min(1, a) > 0 ? a : 1'}", "{x: 'min(1, (-1.5)) > 0 ? (-1.5) : 1'}");
    replaced("", "");
    replaced("\xc3\xa4 a", "\xc3\xa4 (-1.5)");
}

// the order of (10.30): out of reach, then collision, then reached, and within each nearer or freer
static void closer_is_better(void)
{
    const reach_answer order[] = {
        {.verdict = REACH_FAILED},
        {.verdict = REACH_OUT_OF_REACH, .miss = 0.5},
        {.verdict = REACH_JOINT_LIMIT, .miss = 0.02},
        {.verdict = REACH_OUT_OF_REACH, .miss = 0.0011},
        {.verdict = REACH_COLLISION, .clearance = -0.01},
        {.verdict = REACH_NO_WAY, .clearance = 4e-4},
        {.verdict = REACH_REACHED, .clearance = 6e-4},
        {.verdict = REACH_REACHED, .clearance = 5e-3},
        {.verdict = REACH_REACHED, .clearance = INFINITY},
    };
    double last = -1;
    for (size_t i = 0; i < sizeof order / sizeof *order; i++) {
        const double c = design_closeness(&order[i], 1e-3, 5e-4, 1e-2);
        CHECK(c > last && c >= 0 && c <= 1);
        last = c;
    }
    // (10.30) by hand: 9.1 mm too far, 10 mm counts as short
    const reach_answer far = {.verdict = REACH_OUT_OF_REACH, .miss = 10.1e-3};
    CHECK_NEAR(design_closeness(&far, 1e-3, 0, 1e-2), 10 / 19.1 / 3, 1e-14);
    const reach_answer deep = {.verdict = REACH_COLLISION, .clearance = -2e-3};
    CHECK_NEAR(design_closeness(&deep, 1e-3, 5e-4, 1e-2), (1 + 10 / 12.5) / 3, 1e-14);
    const reach_answer free = {.verdict = REACH_REACHED, .clearance = 2.5e-3};
    CHECK_NEAR(design_closeness(&free, 1e-3, 5e-4, 1e-2), (2 + 2. / 12) / 3, 1e-14);
}

int main(void)
{
    names_become_numbers_and_nothing_else_does();
    closer_is_better();
    return test_failures != 0;
}
