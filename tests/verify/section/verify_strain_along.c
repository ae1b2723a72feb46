// tests/verify/section/verify_strain_along.c
// Strains along a rod: sections that are another's, turned, scaled or mirrored, give what solving
// them where they are gives.
#include "base/memory.h"
#include "section/extremes.h"
#include "section/strain_along.h"
#include "tests/test.h"

static const double pi = 3.14159265358979323846, length = 0.1;
enum { SAMPLES = 11 };

static const material two[2] = {{.name = "soft", .E = 0.66e6, .nu = 0.45},
                                {.name = "stiff", .E = 15.93e6, .nu = 0.3}};

// so that nothing turns at a rate where it is looked at
static double stepping(const void *unused, double s)
{
    (void)unused;
    return s < 0.47 * length ? 0.3 : 2.1;
}

static double narrowing(const void *unused, double s)
{
    (void)unused;
    return 1 - 0.6 * s / length;
}

// a sector between two others: what it is mirrored is not what it is turned
static double back_and_forth(const void *unused, double s)
{
    (void)unused;
    return s < 0.47 * length ? 0.9 : -0.9;
}

typedef struct small_case {
    shape_spec shapes[3];
    section_case c;
} small_case;

static void make(small_case *k, int model)
{
    const ring_spec ring = {
        .at = {1, 1}, .outer_radius = field_constant(4e-3), .inner_radius = field_constant(3e-3)};
    *k = (small_case){.c = section_case_default()};
    k->shapes[0] = (shape_spec){.at = {1, 1}, .annulus = ring};
    k->shapes[1] = (shape_spec){.at = {2, 1}, .sector = ring, .material_index = 1};
    k->shapes[1].sector.mid_angle = field_constant(0.4);
    k->shapes[1].sector.width = field_constant(0.6);
    k->shapes[2] = k->shapes[1];
    k->shapes[2].sector.mid_angle = field_constant(0);
    k->shapes[2].sector.width = field_constant(0.25);
    k->c.model = model;
    k->c.mesh.order = 3;
    k->c.nmaterial = 2;
    k->c.shapes = (key_list){.count = 2, .items = k->shapes};
}

static vec6 wrench_at(int sample)
{
    return (vec6){{0.1 * sin(sample), 0.2, -1 + 0.1 * sample, 1e-3 * cos(sample), 2e-3,
                   1e-3 * sin(2 * sample)}};
}

// one sample's strain by a solve at its own place
static void solve_there(const section_case *c, double s, const vec6 *wrench, section_extreme out[2])
{
    mesh m = {0};
    beam_law law = {0};
    section_warping warping = {0};
    section_fields f = {0};
    CHECK_OK(section_mesh_at(c, s, &m));
    if (c->model == MODEL_CLASSICAL) {
        CHECK_OK(section_classical_mesh(&m, two, &law));
        CHECK_OK(section_fields_classical(&m, two, &law.K, &f));
    } else {
        CHECK_OK(section_full_mesh(&m, two, &law, &warping));
        CHECK_OK(section_fields_make(&m, &warping, 0, &f));
    }
    section_largest_strain(&f, wrench, out, NULL);
    section_fields_free(&f);
    section_warping_free(&warping);
    mesh_free(&m);
}

// worst difference of all samples, each by itself
static double worst_miss(const section_case *c, bool places)
{
    double worst = 0;
    law_along first = {0}; // the one that is solved is the first sample, under no wrench
    CHECK_OK(law_along_make(length, 1, 1, &first));
    CHECK_OK(section_solve(c, two, 0, 0, &first.law[0]));
    for (int i = 0; i < SAMPLES; i++) {
        const double s[2] = {0, length * i / (SAMPLES - 1)};
        const vec6 wrenches[2] = {{{0}}, wrench_at(i)};
        const section_wrenches_along along = {2, s, 1, wrenches};
        section_strain_place found[2] = {{0}};
        section_extreme wanted[2] = {{0}};
        CHECK_OK(section_strain_along(c, two, &first, &along, found));
        solve_there(c, s[1], &wrenches[1], wanted);
        for (int m = 0; m < 2; m++) {
            worst = fmax(worst, fabs(found[m].value / wanted[m].value - 1));
            const double away =
                hypot(found[m].at[0] - wanted[m].at[0], found[m].at[1] - wanted[m].at[1]);
            CHECK(!places || away < 1e-6 || fabs(found[m].s - s[1]) > 0);
        }
    }
    law_along_free(&first);
    return worst;
}

static void moved_sections_strain_as_solved_ones(void)
{
    for (int model = MODEL_FULL; model <= MODEL_CLASSICAL; model++) {
        // rounding of the solves, for the meshes move with their sections; the classical K is in
        // closed form here, and on a mesh in what it is held against
        const double rounding = model == MODEL_FULL ? 1e-10 : 1e-7;
        small_case k;
        make(&k, model);
        k.shapes[1].sector.mid_angle.at = stepping;
        const double turned = worst_miss(&k.c, true);
        make(&k, model);
        k.c.scale = (field){.value = 1, .at = narrowing};
        const double scaled = worst_miss(&k.c, true);
        make(&k, model);
        k.c.shapes.count = 3;
        k.shapes[2].sector.mid_angle.at = back_and_forth;
        k.shapes[1].sector.mid_angle = field_constant(0);
        k.shapes[1].sector.width = field_constant(0.5);
        const double mirrored = worst_miss(&k.c, true);
        printf("%s: strains of turned, scaled, mirrored sections off by %.1e, %.1e, %.1e\n",
               model == MODEL_FULL ? "full" : "classical", turned, scaled, mirrored);
        CHECK_BELOW(turned, rounding);
        CHECK_BELOW(scaled, rounding);
        CHECK_BELOW(mirrored, rounding);
    }
}

// a homogeneous tube: |eps| + |kappa| r, and sideways less
static void tube_in_tension_and_bending(void)
{
    small_case k;
    section_result r = {0};
    make(&k, MODEL_FULL);
    k.c.shapes.count = 1;
    CHECK_OK(section_along(&k.c, two, length, &r));
    const double s[2] = {0, length}, area = pi * (16 - 9) * 1e-6;
    const double I = pi * (256 - 81) / 4 * 1e-12, E = two[0].E;
    const vec6 wrenches[2] = {{{0, 0, -0.5, 1e-3, 0, 0}}, {{0, 0, -1, 1e-3, 0, 0}}};
    const section_wrenches_along along = {2, s, 1, wrenches};
    section_strain_place found[2] = {{0}};
    CHECK_OK(section_strain_along(&k.c, two, &r.along, &along, found));
    CHECK_NEAR(found[0].value, -1 / (E * area) - 1e-3 * 4e-3 / (E * I), 1e-3); // nodes
    CHECK_WITHIN(found[0].s, length, 0);
    CHECK_NEAR(found[0].at[1], -4e-3, 1e-2);
    CHECK_WITHIN(found[1].value, 0, 0); // there is none of it
    section_result_free(&r);
}

int main(void)
{
    against(BY_SECOND_WAY, "each section solved where it is");
    moved_sections_strain_as_solved_ones();
    against(BY_CLOSED_FORM, "a homogeneous tube");
    tube_in_tension_and_bending();
    return test_failures != 0;
}
