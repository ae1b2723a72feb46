// tests/verify/section/verify_estimate.c
// The error estimate that comes with each section, against the true error: a reference on a mesh
// four times finer.
#include "tests/verify/section/hand_meshes.h"

#include "section/solve.h"

typedef struct bounds {
    double low, high; // of estimate / truth
} bounds;

static beam_law estimated(const section_outline *o, const material *m, int order, double size)
{
    section_case c = section_case_default();
    beam_law law = {0};
    bool meshed = false;
    c.mesh.order = order;
    c.mesh.size = size;
    CHECK_OK(section_solve_outline(&c, m, o, &law, &meshed));
    CHECK(meshed);
    return law;
}

// An estimate may be far too large where the section is smooth, for orders decay faster than it
// dares to believe; it may not be much too small.
static void compare(const char *name, const section_outline *o, const material *m, double size,
                    bounds b)
{
    const beam_law truth = estimated(o, m, 4, size / 3);
    for (int p = 1; p <= ELEMENT_MAX_ORDER; p++) {
        const beam_law law = estimated(o, m, p, size);
        const double error = mat6_relative_error(law.K, truth.K);
        const double ratio = law.relative_error / error;
        printf("%s order %d: true %.2e, estimate %.2e, ratio %.2f\n", name, p, error,
               law.relative_error, ratio);
        CHECK(ratio > b.low && ratio < b.high);
    }
}

static void straight_classical_section_is_exact(void)
{
    const material m = {.E = 2, .nu = 0.3};
    outline r = {.kind = KIND_RECTANGLE, .size = {4, 1}, .centre = {1, 2}};
    const section_outline o = {.count = 1, .items = &r, .size = 4};
    section_case c = section_case_default();
    beam_law law = {0};
    bool meshed = false;
    c.model = MODEL_CLASSICAL;
    CHECK_OK(section_solve_outline(&c, &m, &o, &law, &meshed));
    CHECK(meshed && law.relative_error < 1e-10);
    CHECK_NEAR(law.K.a[NZ][NZ], 8, 1e-13);
}

int main(void)
{
    material m[2];
    prototype p;
    prototype_materials(0.3, 0.3, m);
    prototype_set(&p, 2, pi, pi / 8);
    compare("constant NC", &p.all, m, 0.8e-3, (bounds){0.7, 100});
    prototype_set(&p, 1, 0, 0);
    compare("annulus", &p.all, m, 0.8e-3, (bounds){0.9, 1000});

    const material one = {.E = 1, .nu = 0.3};
    outline r = {.kind = KIND_RECTANGLE, .size = {4, 1}};
    compare("rectangle", &(section_outline){.count = 1, .items = &r, .size = 2.1}, &one, 0.5,
            (bounds){0.9, 100});
    outline legs[2] = {{.kind = KIND_RECTANGLE, .size = {6, 1}, .centre = {3, 0.5}},
                       {.kind = KIND_RECTANGLE, .size = {1, 10}, .centre = {0.5, 5}}};
    // the reference itself keeps a quarter of the coarse mesh's error here
    compare("angle", &(section_outline){.count = 2, .items = legs, .size = 11.7}, &one, 0.5,
            (bounds){0.7, 4});
    straight_classical_section_is_exact();
    return test_failures != 0;
}
