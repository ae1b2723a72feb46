// tests/verify/section/verify_tolerance_kept.c
// What is told of a section meets the tolerance that was asked for: where a mesh of the way there
// cannot be made, and where the pattern lies askew.
#include "section/section.h"
#include "tests/sections.h"
#include "tests/test.h"

#include <math.h>

static section_case case_of(sample *s, double tolerance)
{
    section_case c = section_case_default();
    c.shapes = (key_list){.count = s->nshape, .items = s->shape};
    c.nmaterial = 1;
    c.tolerance = tolerance;
    return c;
}

// Eight corners, four of them turned inwards: deep layers of elements fail to be drawn here, and a
// smaller step is tried then
static void star(void)
{
    double corner[8][2];
    sample s = {0};
    beam_law loose = {0}, tight = {0};
    for (int i = 0; i < 8; i++) {
        const double r = i % 2 == 0 ? 3e-3 : 0.85e-3, a = PI / 4 * i;
        corner[i][0] = r * cos(a);
        corner[i][1] = r * sin(a);
    }
    s.material[0] = isotropic(1e6, 0.3);
    shape_spec shape = {.polygon = {.at = {1, 1}, .points = {{1, 1}, 8, 2, corner[0]}}};
    sample_add(&s, shape);
    section_case c = case_of(&s, 1e-5);
    CHECK_OK(section_solve(&c, s.material, 0, 0, &loose));
    const double tightest = test_is_long() ? 1e-7 : 1e-6;
    c = case_of(&s, tightest);
    CHECK_OK(section_solve(&c, s.material, 0, 0, &tight));
    printf("star: %.1e and %.1e, %.1e apart\n", loose.relative_error, tight.relative_error,
           mat6_relative_error(loose.K, tight.K));
    CHECK_AT_MOST(loose.relative_error, 1e-5);
    CHECK_AT_MOST(tight.relative_error, tightest);
    CHECK_AT_MOST(mat6_relative_error(loose.K, tight.K), 3 * loose.relative_error);
}

// turned to its pattern and back the bounds of the entries would widen by half
static void askew(void)
{
    sample s = {0};
    section_result r = {0};
    sample_sector(&s, PI / 8, 24, 0.3);
    s.shape[1].sector.mid_angle = field_constant(1);
    section_case c = case_of(&s, 1e-6);
    c.nmaterial = 2;
    CHECK_OK(section_along(&c, s.material, 1, &r));
    printf("askew: %.1e\n", r.station[0].law.relative_error);
    CHECK_AT_MOST(r.station[0].law.relative_error, 1e-6);
    section_result_free(&r);
}

int main(void)
{
    against(BY_SECOND_WAY, "the same section at a finer tolerance");
    star();
    askew();
    return test_failures != 0;
}
