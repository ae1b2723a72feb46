// tests/unit/section/test_along.c
#include "section/section.h"
#include "tests/test.h"

#include <string.h>

static const double pi = 3.14159265358979323846, length = 0.12;

static const material two[2] = {{.name = "soft", .E = 0.66e6, .nu = 0.3},
                                {.name = "stiff", .E = 15.93e6, .nu = 0.3}};

static double half_turn(const void *expression, double s)
{
    (void)expression;
    return pi * s / length;
}

static double swing(const void *expression, double s)
{
    (void)expression;
    return sin(9 * s / length);
}

static double narrowing(const void *expression, double s)
{
    (void)expression;
    return pi / 4 - pi / 8 * s / length;
}

static double jump(const void *expression, double s)
{
    (void)expression;
    return s < 0.0437 ? pi / 4 : pi / 8;
}

typedef double (*function)(const void *, double);

// annulus and stiff sector; NULL: pi and pi/8
static section_case prototype(int model, function middle, function width, shape_spec shapes[2])
{
    const ring_spec ring = {.outer_radius = field_constant(4e-3),
                            .inner_radius = field_constant(3.2e-3)};
    shapes[0] = (shape_spec){.annulus = ring, .material_index = 0};
    shapes[0].annulus.at = (mark){1, 1};
    shapes[1] = (shape_spec){.sector = ring, .material_index = 1};
    shapes[1].sector.at = (mark){2, 1};
    shapes[1].sector.mid_angle = (field){.value = pi, .at = middle};
    shapes[1].sector.width = (field){.value = pi / 8, .at = width};
    section_case c = section_case_default();
    c.model = model;
    c.shapes = (key_list){.count = 2, .items = shapes};
    return c;
}

// the law at s against a solve there
static double miss_at(const section_case *c, const section_result *r, double s)
{
    beam_law law = {0};
    mat6 K;
    CHECK_OK(section_solve(c, two, s, length, &law));
    law_along_at(&r->along, s, &K, NULL);
    return mat6_relative_error(K, law.K);
}

static void nothing_varies(void)
{
    shape_spec shapes[2];
    section_case c = prototype(MODEL_FULL, NULL, NULL, shapes);
    section_result r = {0};
    CHECK_OK(section_along(&c, two, length, &r));
    CHECK(r.nstation == 1 && r.effort.nsolved == 1 && r.effort.meshed);
    CHECK(r.station[0].s == 0);
    CHECK(r.along.npanel == 1 && r.along.nnode == 1);
    CHECK_NEAR(r.station[0].centres.principal_angle, pi, 1e-12);
    CHECK(r.station[0].law.relative_error > 0);
    CHECK(miss_at(&c, &r, 0.05) < 1e-14);
    section_result_free(&r);
}

static void pattern_turns_in_one_solve(void)
{
    shape_spec shapes[2];
    section_case c = prototype(MODEL_FULL, half_turn, NULL, shapes);
    section_result r = {0};
    CHECK_OK(section_along(&c, two, length, &r));
    CHECK(r.effort.nsolved == 1);
    // turned by the law against turned before meshing: rounding of the two solves
    CHECK(miss_at(&c, &r, 0.0317) < 1e-10);
    section_result_free(&r);

    // the paper's model does not know rates: any turn is one solve
    c = prototype(MODEL_CLASSICAL, swing, NULL, shapes);
    CHECK_OK(section_along(&c, two, length, &r));
    CHECK(r.effort.nsolved == 1 && r.along.nnode > 9);
    CHECK(miss_at(&c, &r, 0.0317) < 1e-9);
    section_result_free(&r);
}

// helical prototype: rods need K(s) much better than their 1e-9 m
static void helical_prototype_by_closed_form(void)
{
    shape_spec shapes[2];
    section_case c = prototype(MODEL_CLASSICAL, half_turn, narrowing, shapes);
    section_result r = {0};
    CHECK_OK(section_along(&c, two, length, &r));
    CHECK(!r.effort.meshed);
    double most = 0;
    for (int i = 0; i <= 100; i++) {
        most = fmax(most, miss_at(&c, &r, length * i / 100));
    }
    printf("helical, classical: %d nodes, %d solved, said %.1e, true %.1e\n", r.along.nnode,
           r.effort.nsolved, r.along.relative_error, most);
    CHECK(most < 1e-10);
    CHECK(most <= 10 * r.along.relative_error);
    for (int i = 0; i < r.nstation; i++) {
        CHECK_WITHIN(r.station[i].centres.principal_angle, pi * r.station[i].s / length, 1e-10);
    }
    section_result_free(&r);
}

static void helical_prototype_with_warping(void)
{
    shape_spec shapes[2];
    section_case c = prototype(MODEL_FULL, half_turn, narrowing, shapes);
    section_result r = {0};
    CHECK_OK(section_along(&c, two, length, &r));
    CHECK(r.effort.meshed);
    const double miss = fmax(miss_at(&c, &r, 0.031), miss_at(&c, &r, 0.077));
    printf("helical, full: %d nodes, %d solved, said %.1e, seen %.1e, sections %.1e\n",
           r.along.nnode, r.effort.nsolved, r.along.relative_error, miss,
           r.along.law[0].relative_error);
    // not closer than the sections are known
    CHECK(miss < 2e-5);
    section_result_free(&r);
}

static void stations_asked_for(void)
{
    shape_spec shapes[2];
    double s[3] = {0, 0.06, 0.12};
    section_case c = prototype(MODEL_CLASSICAL, half_turn, narrowing, shapes);
    section_result r = {0};
    c.stations = (key_rows){.nrow = 1, .ncol = 3, .a = s};
    CHECK_OK(section_along(&c, two, length, &r));
    CHECK(r.nstation == 3);
    for (int i = 0; i < 3; i++) {
        beam_law law = {0};
        CHECK(r.station[i].s == s[i]);
        CHECK_OK(section_solve(&c, two, s[i], length, &law));
        CHECK(mat6_relative_error(r.station[i].law.K, law.K) < 1e-13);
    }
    section_result_free(&r);
    s[2] = 0.13;
    CHECK(section_along(&c, two, length, &r) == ERR_INPUT);
    CHECK(strstr(status_message(), "130 mm") != NULL);
    status_clear();
}

// no declared axis of symmetry: the axis of the largest int E x'^2 first, then without a jump
static void principal_axis_is_continuous(void)
{
    shape_spec shape = {.rectangle = {.at = {1, 1},
                                      .width = field_constant(4e-3),
                                      .height = field_constant(1e-3),
                                      .angle = {.at = half_turn}},
                        .material_index = 0};
    section_case c = section_case_default();
    section_result r = {0};
    c.model = MODEL_CLASSICAL;
    c.shapes = (key_list){.count = 1, .items = &shape};
    CHECK_OK(section_along(&c, two, length, &r));
    CHECK(r.nstation >= 5);
    for (int i = 0; i < r.nstation; i++) {
        CHECK_WITHIN(r.station[i].centres.principal_angle, pi * r.station[i].s / length, 1e-9);
    }
    section_result_free(&r);
}

static void a_jump_is_refused_with_its_place(void)
{
    shape_spec shapes[2];
    section_case c = prototype(MODEL_CLASSICAL, half_turn, jump, shapes);
    section_result r = {0};
    CHECK(section_along(&c, two, length, &r) == ERR_NUMERIC);
    // 16 panels of 7.5 mm: the jump lies in the one from 37.5 mm to 45 mm
    CHECK(strstr(status_message(), "between s = 37.5 mm and 45 mm") != NULL);
    status_clear();
}

int main(void)
{
    nothing_varies();
    pattern_turns_in_one_solve();
    helical_prototype_by_closed_form();
    helical_prototype_with_warping();
    stations_asked_for();
    principal_axis_is_continuous();
    a_jump_is_refused_with_its_place();
    return test_failures != 0;
}
