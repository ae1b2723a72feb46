// tests/verify/section/verify_thin_walls.c
#include "section/section.h"
#include "tests/shapes.h"
#include "tests/test.h"

// a strip's EI = E b t^3 / 12 and GJ = G b t^3 / 3 (1 - 0.630 t / b) are met to the error that is
// said down to 1000 times as long as thick; thinner ones are refused with their place, not guessed
static void thin_strips_tell_their_rounding(void)
{
    const material m = {.E = 1e6, .nu = 0.3};
    const double b = 0.1, thick[] = {1e-3, 1e-4, 1e-5};
    for (int i = 0; i < 3; i++) {
        const double t = thick[i], cube = b * t * t * t;
        shape_spec strip = a_rectangle(b, t, 0, 0, 0, 0);
        section_case c = section_case_default();
        beam_law law = {0};
        int line = 0, column = 0;
        c.shapes = (key_list){.count = 1, .items = &strip};
        if (i == 2) {
            CHECK(section_solve(&c, &m, 0, 0, &law) == ERR_NUMERIC);
            CHECK(status_place(&line, &column) && line == strip.at.line);
            status_clear();
            break;
        }
        CHECK_OK(section_solve(&c, &m, 0, 0, &law));
        // rounding grows as (b / t)^4 and is a matter of luck within a factor of ten; beyond 1e-2
        // the section is refused
        CHECK_BELOW(law.relative_error, (i == 0 ? 1e-4 : 1e-2));
        CHECK_NEAR(law.K.a[MX][MX], m.E * cube / 12, law.relative_error + 1e-9);
        CHECK_NEAR(law.K.a[MZ][MZ], m.E / 2.6 * cube / 3 * (1 - 0.63025 * t / b),
                   law.relative_error + 1e-5);
    }
}

int main(void)
{
    against(BY_CLOSED_FORM, "a strip: E b t^3 / 12 and G b t^3 / 3 (1 - 0.630 t / b)");
    thin_strips_tell_their_rounding();
    return test_failures != 0;
}
