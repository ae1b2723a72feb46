// tests/verify/section/verify_estimate.c
// The error estimate that comes with each section, against the true error: a reference of order 4
// on a mesh two to eight times finer.
#include "tests/verify/section/hand_meshes.h"

#include "tests/verify/section/campaign.h"

#include "section/solve.h"

#include <math.h>

static beam_law estimated(const section_outline *o, const material *m, int order, double size)
{
    section_case c = section_case_default();
    beam_law law = {0};
    section_used used = {0};
    c.mesh.order = order;
    c.mesh.size = size;
    CHECK_OK(section_solve_place(&c, m, &(section_place){.drawn = true, .outline = *o, .scale = 1},
                                 &law, &used));
    CHECK(used.meshed);
    return law;
}

// smooth sections: every order gains more than the estimate dares to believe
static const double no_most = INFINITY;
// where corners and interfaces slow the decay down, an estimate tells the size of the error
static const double most = 100;

static beam_law reference(const section_outline *o, const material *m, double size)
{
    return estimated(o, m, ELEMENT_MAX_ORDER, size);
}

// The estimate is never below the true error, nor beyond `largest` times of it.
static void compare(const char *name, const section_outline *o, const material *m, double size,
                    beam_law truth, double largest)
{
    about("%s", name);
    for (int p = 1; p <= ELEMENT_MAX_ORDER; p++) {
        const beam_law law = estimated(o, m, p, size);
        const double error = mat6_relative_error(law.K, truth.K);
        printf("%s size %.3g order %d: true %.2e, estimate %.2e, ratio %.2f\n", name, size, p,
               error, law.relative_error, law.relative_error / error);
        CHECK_ABOVE(error, 0);
        CHECK_AT_MOST(error, law.relative_error);
        CHECK_AT_MOST(law.relative_error, largest * error);
    }
}

// Free meshes of the catheter of cases/catheter.yaml: unequal Poisson's ratios, and corners where
// materials meet inside and at free edges.
static void catheter(void)
{
    const material m[2] = {{.name = "body", .E = 12e6, .nu = 0.45},
                           {.name = "wedge", .E = 170e6, .nu = 0.4}};
    outline item[6] = {
        {.kind = KIND_DISC, .outer = 2e-3},
        {.kind = KIND_SECTOR,
         .material = 1,
         .outer = 2e-3,
         .inner = 0.9e-3,
         .mid_angle = pi,
         .width = pi / 3},
        {.kind = KIND_DISC, .material = -1, .outer = 0.8e-3, .centre = {0.75e-3, 0}},
        {.kind = KIND_DISC, .material = -1, .outer = 0.2e-3, .centre = {-0.3e-3, 0.95e-3}},
        {.kind = KIND_DISC, .material = -1, .outer = 0.2e-3, .centre = {0, 1.55e-3}},
        {.kind = KIND_DISC, .material = -1, .outer = 0.2e-3, .centre = {0, -1.55e-3}},
    };
    const section_outline o = {.count = 6, .items = item, .size = 2e-3};
    const beam_law truth = reference(&o, m, 0.05e-3);
    compare("catheter", &o, m, 0.15e-3, truth, most);
    compare("catheter", &o, m, 0.1e-3, truth, most);
}

static void constant_nc(double nu_soft, double nu_stiff)
{
    material m[2];
    prototype p;
    prototype_materials(nu_soft, nu_stiff, m);
    prototype_set(&p, 2, pi, pi / 8);
    const beam_law truth = reference(&p.all, m, 0.15e-3);
    compare("constant NC", &p.all, m, 0.8e-3, truth, most);
    compare("constant NC", &p.all, m, 0.4e-3, truth, most);
}

static void annulus(void)
{
    material m[2];
    prototype p;
    prototype_materials(0.3, 0.3, m);
    prototype_set(&p, 1, 0, 0);
    compare("annulus", &p.all, m, 0.8e-3, reference(&p.all, m, 0.2e-3), no_most);
}

static void rectangle(void)
{
    const material one = {.E = 1, .nu = 0.3};
    outline r = {.kind = KIND_RECTANGLE, .size = {4, 1}};
    const section_outline o = {.count = 1, .items = &r, .size = 2.1};
    compare("rectangle", &o, &one, 0.5, reference(&o, &one, 0.125), most);
}

// the re-entrant corner decays slowest: the reference is three to six times finer
static void angle_section(void)
{
    const material one = {.E = 1, .nu = 0.3};
    outline legs[2] = {{.kind = KIND_RECTANGLE, .size = {6, 1}, .centre = {3, 0.5}},
                       {.kind = KIND_RECTANGLE, .size = {1, 10}, .centre = {0.5, 5}}};
    const section_outline o = {.count = 2, .items = legs, .size = 11.7};
    const beam_law truth = reference(&o, &one, 0.08);
    compare("angle", &o, &one, 0.5, truth, most);
    compare("angle", &o, &one, 0.25, truth, most);
}

static void straight_classical_section_is_exact(void)
{
    const material m = {.E = 2, .nu = 0.3};
    outline r = {.kind = KIND_RECTANGLE, .size = {4, 1}, .centre = {1, 2}};
    const section_outline o = {.count = 1, .items = &r, .size = 4};
    section_case c = section_case_default();
    beam_law law = {0};
    section_used used = {0};
    c.model = MODEL_CLASSICAL;
    CHECK_OK(section_solve_place(&c, &m, &(section_place){.drawn = true, .outline = o, .scale = 1},
                                 &law, &used));
    CHECK(used.meshed);
    CHECK_BELOW(law.relative_error, 1e-10);
    CHECK_NEAR(law.K.a[NZ][NZ], 8, 1e-13);
}

// A few of the kinds that bench/bench_estimate.c holds to the same promise.
static void every_kind_at_the_default_mesh(void)
{
    campaign sum = {0};
    const mesh_options mesh = mesh_options_default();
    campaign_head();
    for (int k = 0; k < SAMPLES; k++) {
        sample s;
        beam_law truth = {0};
        measured m = {0};
        sample_make(k, &s);
        if (s.in_short) {
            CHECK_OK(sample_reference(&s, &mesh, &truth));
            CHECK_OK(sample_solve(&s, &mesh, 0, &m));
            campaign_row(&sum, s.name, "default", &m, &truth);
        }
    }
    CHECK(sum.count == 11 && sum.below == 0 && sum.beyond == 0);
}

// What is asked for is met, by the truth as by the estimate; what cannot be is refused.
static void a_tolerance_is_met(void)
{
    const double tolerance[] = {1e-3, 1e-4, 1e-5, 1e-6};
    const int kinds[] = {3, 9, 25};
    const mesh_options mesh = mesh_options_default();
    for (int i = 0; i < 12; i++) {
        sample s;
        beam_law truth = {0};
        measured m = {0};
        sample_make(kinds[i / 4], &s);
        CHECK_OK(sample_reference(&s, &mesh, &truth));
        CHECK_OK(sample_solve(&s, &mesh, tolerance[i % 4], &m));
        CHECK_AT_MOST(m.law.relative_error, tolerance[i % 4]);
        CHECK_AT_MOST(mat6_relative_error(m.law.K, truth.K), tolerance[i % 4]);
    }
    sample s;
    measured m = {0};
    sample_make(3, &s);
    CHECK(sample_solve(&s, &mesh, 1e-14, &m) == ERR_NUMERIC);
    CHECK(strstr(status_message(), "rounding") != NULL);
    status_clear();
}

// An order that the case gives stands.
static void an_order_given_is_kept(void)
{
    sample s;
    measured asked = {0}, plain = {0};
    mesh_options mesh = mesh_options_default();
    mesh.order = 3; // 2 would be enough
    mesh.order_chosen = false;
    sample_make(9, &s);
    CHECK_OK(sample_solve(&s, &mesh, 0, &plain));
    CHECK_OK(sample_solve(&s, &mesh, 1e-2, &asked));
    CHECK_WITHIN(mat6_relative_error(asked.law.K, plain.law.K), 0, 0);
}

int main(void)
{
    against(BY_SECOND_WAY, "sections of order 4 on meshes two to eight times finer");
    every_kind_at_the_default_mesh();
    a_tolerance_is_met();
    an_order_given_is_kept();

    catheter();
    constant_nc(0.3, 0.3);
    constant_nc(0.45, 0.3);
    annulus();
    rectangle();
    angle_section();
    straight_classical_section_is_exact();
    return test_failures != 0;
}
