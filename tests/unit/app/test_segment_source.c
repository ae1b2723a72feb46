// tests/unit/app/test_segment_source.c
// Bodies of cases: volumes, interfaces, poses.
#include "section/section.h"
#include "tests/unit/app/made_body.h"

// the helical prototype: its volume is the tube's, and what is stiff of it the mean width's
static void the_helical_robot_has_its_volumes(void)
{
    made m;
    char shapes[400];
    (void)snprintf(shapes, sizeof shapes,
                   "  shapes:\n%s    - {sector: {outer_radius_mm: 4, inner_radius_mm: 3.2, "
                   "mid_angle_rad: pi*s/L, width_rad: pi/4 - (pi/8)*(s/L)}, material: stiff}\n",
                   annulus);
    CHECK_OK(make(shapes, "fem: {length_mm: 120, loads: []}\n", fine, 16, &m));
    CHECK(m.spec.shape.place && m.spec.turn_rate == 0 && !m.source.fixed_layers);
    CHECK_NEAR(m.source.nu, 0.3, 1e-15);
    // half a turn and a bit for the width, layers no longer than pi/8
    CHECK(m.source.sections_along >= 8 && m.source.sections_along <= 12);
    const body_volume v = body_volumes(&m.body);
    const double ring = 4e-3 * 4e-3 - 3.2e-3 * 3.2e-3, length = 0.12;
    const double stiff = 3 * PI / 16 / 2 * ring * length, all = PI * ring * length;
    CHECK_NEAR(v.of[1], stiff, 1e-10);
    CHECK_NEAR(v.of[0] + v.of[1], all, 1e-10);
    CHECK(v.smallest > 0.5);
    unmake(&m);
}

// the plane mesh between levels, by the layers' own basis
static void slice_at(const body *b, double s, mesh *m)
{
    int layer = 0;
    double N[ELEMENT_MAX_ORDER + 1];
    while (layer + 1 < b->nlayer && b->level[(layer + 1) * b->order] <= s) {
        layer++;
    }
    const double begin = b->level[layer * b->order], end = b->level[(layer + 1) * b->order];
    const double t = 2 * (s - begin) / (end - begin) - 1;
    element_basis(&b->line, &t, N, NULL);
    for (int i = 0; i < m->nnode; i++) {
        double at[3] = {0};
        for (int k = 0; k <= b->order; k++) {
            double x[3];
            body_node(b, i, layer * b->order + k, x);
            at[0] += N[k] * x[0];
            at[1] += N[k] * x[1];
        }
        memcpy(m->xyz + 3 * i, at, sizeof at);
    }
}

// E over a slice between levels: that of the section drawn there
static void interfaces_are_kept_between_levels(void)
{
    made m;
    mesh slice = {0};
    const char shapes[] =
        "  model: classical\n  shapes:\n    - {annulus: {outer_radius_mm: 4 - 0.01*s, "
        "inner_radius_mm: 3.2}, material: soft}\n    - {sector: {outer_radius_mm: 4 - 0.01*s, "
        "inner_radius_mm: 3.2, mid_angle_rad: pi*s/L, width_rad: pi/4 - (pi/8)*sin(s/L)}, "
        "material: stiff}\n";
    CHECK_OK(make(shapes, "fem: {length_mm: 60, loads: []}\n", fine, 24, &m));
    CHECK_OK(mesh_copy(&m.plane, &slice));
    for (int k = 0; k < 20; k++) {
        const double s = 0.0013 + 0.003 * k * (1 - 0.003 * k);
        beam_law kept = {0}, drawn = {0};
        slice_at(&m.body, s, &slice);
        CHECK_OK(section_classical_mesh(&slice, m.source.materials, &kept));
        CHECK_OK(section_solve(&m.c.file.section, m.source.materials, s, 0.06, &drawn));
        CHECK_NEAR(kept.K.a[2][2], drawn.K.a[2][2], 1e-8);
        const double radius = 4e-3;
        CHECK_WITHIN(kept.K.a[2][3], drawn.K.a[2][3], 1e-8 * drawn.K.a[2][2] * radius);
        CHECK_WITHIN(kept.K.a[2][4], drawn.K.a[2][4], 1e-8 * drawn.K.a[2][2] * radius);
        CHECK_NEAR(kept.K.a[3][3], drawn.K.a[3][3], 1e-8);
        CHECK_NEAR(kept.K.a[4][4], drawn.K.a[4][4], 1e-8);
    }
    mesh_free(&slice);
    unmake(&m);
}

static void a_constant_turn_is_a_prism_that_turns(void)
{
    made m;
    char shapes[400];
    (void)snprintf(shapes, sizeof shapes,
                   "  shapes:\n%s    - {sector: {outer_radius_mm: 4, inner_radius_mm: 3.2, "
                   "mid_angle_rad: 1 + 2*pi*s/0.03, width_rad: pi/8}, material: stiff}\n",
                   annulus);
    CHECK_OK(make(shapes, "fem: {length_mm: 30, loads: []}\n", fine, 20, &m));
    CHECK(!m.spec.shape.place);
    CHECK_NEAR(m.spec.turn_rate, 2 * PI / 0.03, 1e-9);
    CHECK(m.source.sections_along >= 16 && m.source.sections_along <= 17);
    unmake(&m);
    // the twist of the rod at rest adds to it
    CHECK_OK(make(shapes,
                  "rod: {length_mm: 60, rest: {twist_rad_per_m: -10}}\n"
                  "fem: {length_mm: 30, section_at_mm: 20, loads: []}\n",
                  fine, 20, &m));
    CHECK_NEAR(m.spec.turn_rate, 2 * PI / 0.03 - 10, 1e-9);
    unmake(&m);
    // nothing turns in a prism
    CHECK_OK(make(shapes, "fem: {length_mm: 30, body: prism, loads: []}\n", fine, 20, &m));
    CHECK(!m.source.course && m.body.prism && m.source.sections_along == 0);
    unmake(&m);
}

// the same body by its shape and by its rate: twist that varies by nothing
static void turning_by_shape_is_turning_by_rate(void)
{
    made a, b;
    const char shapes[] = "  shapes:\n    - {disc: {radius_mm: 4}, material: soft}\n"
                          "    - {rectangle: {width_mm: 2, height_mm: 1, centre_x_mm: 1}, "
                          "material: stiff}\n  turn_rad: 100*s\n";
    const char still[] = "  shapes:\n    - {disc: {radius_mm: 4}, material: soft}\n"
                         "    - {rectangle: {width_mm: 2, height_mm: 1, centre_x_mm: 1}, "
                         "material: stiff}\n";
    const segment_mesh ask = {.order = 2};
    CHECK_OK(make(shapes, "fem: {length_mm: 30, loads: []}\n", ask, 8, &a));
    CHECK_NEAR(a.spec.turn_rate, 100, 1e-9);
    CHECK_OK(make(still,
                  "rod: {length_mm: 30, rest: {twist_rad_per_m: 100 + 0*s}}\n"
                  "fem: {length_mm: 30, loads: []}\n",
                  ask, 8, &b));
    CHECK(b.spec.shape.place != NULL);
    double away = 0;
    for (int level = 0; level < a.body.nlevel && a.plane.nnode == b.plane.nnode; level++) {
        for (int i = 0; i < a.plane.nnode; i++) {
            double x[3], y[3];
            body_node(&a.body, i, level, x);
            body_node(&b.body, i, level, y);
            away = fmax(away, hypot(hypot(x[0] - y[0], x[1] - y[1]), x[2] - y[2]));
        }
    }
    CHECK(a.plane.nnode == b.plane.nnode && away < 1e-13 * 4e-3 * 100);
    unmake(&a);
    unmake(&b);
}

// frustums: int pi r^2 = pi L (a^2 + a b + b^2) / 3
static void a_tapered_tube_has_its_volume(void)
{
    made m;
    CHECK_OK(make("  shapes:\n    - {annulus: {outer_radius_mm: 4 - 0.02*s, inner_radius_mm: 2 - "
                  "0.01*s}, material: soft}\n",
                  "fem: {length_mm: 100, section_at_mm: 10, loads: []}\nrod: {length_mm: 110}\n",
                  fine, 10, &m));
    const body_volume v = body_volumes(&m.body);
    const double a = 3.8e-3, b = 1.8e-3, c = 1.9e-3, d = 0.9e-3;
    CHECK_NEAR(v.of[0], PI * 0.1 / 3 * (a * a + a * b + b * b - c * c - c * d - d * d), 1e-10);
    unmake(&m);
}

// Pappus: the area times the way of its centroid, for a quarter ring
static void a_bent_rod_has_its_volume(void)
{
    made m;
    const char shapes[] = "  shapes:\n    - {rectangle: {width_mm: 3, height_mm: 2, "
                          "centre_x_mm: 0.5}, material: soft}\n";
    CHECK_OK(make(shapes,
                  "rod: {length_mm: 60, rest: {curvature_y_per_m: pi/2/0.03}}\n"
                  "fem: {length_mm: 30, section_at_mm: 10, loads: []}\n",
                  fine, 12, &m));
    const body_volume v = body_volumes(&m.body);
    const double radius = 0.03 / (PI / 2);
    // curvature about y bends towards x: the centroid at +x lies inside
    CHECK_NEAR(v.of[0], 6e-6 * (radius - 0.5e-3) * PI / 2, 1e-10);
    double tip[3];
    body_origin(&m.body, m.body.nlevel - 1, tip);
    CHECK_NEAR(tip[0], radius, 1e-12);
    CHECK_NEAR(tip[2], radius, 1e-12);
    CHECK(m.source.sections_along == 4);
    unmake(&m);
}

// a jump of the curvature within the segment: an arc after a straight part
static void a_hook_is_straight_then_round(void)
{
    made m;
    const char shapes[] = "  shapes:\n    - {rectangle: {width_mm: 3, height_mm: 2}, "
                          "material: soft}\n";
    CHECK_OK(make(shapes,
                  "rod: {length_mm: 60, rest: {curvature_x_per_m: \"s < 0.0237 ? 0 : 50\"}}\n"
                  "fem: {length_mm: 60, loads: []}\n",
                  fine, 16, &m));
    double tip[3];
    body_origin(&m.body, m.body.nlevel - 1, tip);
    const double bend = 50 * (0.06 - 0.0237);
    CHECK_NEAR(tip[2], 0.0237 + sin(bend) / 50, 1e-9);
    CHECK_NEAR(tip[1], -(1 - cos(bend)) / 50, 1e-9);
    unmake(&m);
}

// no grid holds it, and its parts move far against each other: step by step
static void curves_are_followed_step_by_step(void)
{
    made m;
    const char shapes[] =
        "  shapes:\n    - {disc: {radius_mm: 4 - 0.01*s}, material: soft}\n    - {lumens: "
        "{radius_mm: 0.5, count: 4, circle_radius_mm: 2.5 - 0.01*s, first_angle_rad: 100*s}}\n    "
        "- "
        "{ellipse: {semi_axis_x_mm: 1, semi_axis_y_mm: 0.6 + 0.005*s, angle_rad: 100*s}, material: "
        "stiff}\n";
    const segment_mesh ask = {.order = 2, .size = 0.7e-3};
    CHECK_OK(make(shapes, "fem: {length_mm: 60, loads: []}\n", ask, 30, &m));
    CHECK(m.spec.shape.place && m.plane.block[0].shape == SHAPE_TRIANGLE);
    const body_volume v = body_volumes(&m.body);
    // int pi r^2, r from 4 to 3.4; four lumens; int pi a b, b from 0.6 to 0.9
    const double disc = PI * 60e-9 / 3 * (16 + 4 * 3.4 + 3.4 * 3.4), lumens = 4 * PI * 0.25 * 60e-9;
    const double ellipse = PI * 0.75 * 60e-9;
    CHECK_NEAR(v.of[1], ellipse, 2e-4); // helices over 0.15 rad per layer of order 2
    CHECK_NEAR(v.of[0] + v.of[1], disc - lumens, 2e-4);
    CHECK(v.smallest > 0.2);
    unmake(&m);
}

// on a grid at the base, and nowhere else
static void a_strip_turns_within_a_square(void)
{
    made m;
    const char shapes[] = "  shapes:\n    - {rectangle: {width_mm: 8, height_mm: 8}, material: "
                          "soft}\n    - {rectangle: {width_mm: 5, height_mm: 1, angle_rad: 5*s}, "
                          "material: stiff}\n";
    const segment_mesh ask = {.order = 2};
    CHECK_OK(make(shapes, "fem: {length_mm: 60, loads: []}\n", ask, 10, &m));
    const body_volume v = body_volumes(&m.body);
    CHECK_NEAR(v.of[1], 5 * 60e-9, 1e-6);
    CHECK_NEAR(v.of[0], 59 * 60e-9, 1e-6);
    unmake(&m);
}

static bool is_refused(const char *shapes, const char *rest, const char *words)
{
    made m;
    const segment_mesh ask = {.order = 2};
    const status st = make(shapes, rest, ask, 20, &m);
    const bool said = strstr(status_message(), words) != NULL;
    if (st != ERR_INPUT || !said) {
        printf("%d: %s\n", st, status_message());
    }
    unmake(&m);
    return st == ERR_INPUT && said;
}

static void what_cannot_be_followed_is_refused(void)
{
    const char fem[] = "fem: {length_mm: 60, loads: []}\n";
    const char tube[] = "  shapes:\n    - {annulus: {outer_radius_mm: 4, inner_radius_mm: 3}, "
                        "material: soft}\n";
    // the lumen leaves the disc at s = 30 mm
    CHECK(is_refused("  shapes:\n    - {disc: {radius_mm: 4}, material: soft}\n    - {disc: "
                     "{radius_mm: 0.5, centre_x_mm: 2 + 0.05*s}, material: none}\n",
                     fem, "take a shorter 3D body"));
    // one sector goes round into the other
    char two[500];
    (void)snprintf(
        two, sizeof two,
        "%s    - {sector: {outer_radius_mm: 4, inner_radius_mm: 3, mid_angle_rad: 0, "
        "width_rad: 1}, material: stiff}\n    - {sector: {outer_radius_mm: 4, "
        "inner_radius_mm: 3, mid_angle_rad: 2 - 30*s, width_rad: 0.5}, material: stiff}\n",
        tube);
    CHECK(is_refused(two, fem, "its shapes meet or part"));
    CHECK(is_refused(tube,
                     "rod: {length_mm: 60, rest: {curvature_x_per_m: 400}}\n"
                     "fem: {length_mm: 60, loads: []}\n",
                     "folds over itself"));
    char fast[400];
    (void)snprintf(fast, sizeof fast,
                   "%s    - {sector: {outer_radius_mm: 4, inner_radius_mm: 3, mid_angle_rad: "
                   "1e9*s*s, width_rad: 1}, material: stiff}\n",
                   tube);
    CHECK(is_refused(fast, fem, "a mistake of unit"));
}

// many turns between two of the places that are looked at
static void a_fast_turn_keeps_its_rate(void)
{
    made m;
    const char shapes[] =
        "  shapes:\n    - {annulus: {outer_radius_mm: 4, inner_radius_mm: 3}, "
        "material: soft}\n    - {sector: {outer_radius_mm: 4, inner_radius_mm: 3, "
        "mid_angle_rad: 2*pi*s/0.0015, width_rad: 1}, material: stiff}\n";
    const segment_mesh ask = {.order = 1};
    CHECK_OK(make(shapes, "fem: {length_mm: 120, loads: []}\n", ask, 30, &m));
    CHECK_NEAR(m.spec.turn_rate, 2 * PI / 0.0015, 1e-9);
    CHECK(m.source.sections_along == 16 * 80);
    unmake(&m);
}

int main(void)
{
    the_helical_robot_has_its_volumes();
    interfaces_are_kept_between_levels();
    a_constant_turn_is_a_prism_that_turns();
    turning_by_shape_is_turning_by_rate();
    a_tapered_tube_has_its_volume();
    a_bent_rod_has_its_volume();
    a_hook_is_straight_then_round();
    curves_are_followed_step_by_step();
    a_strip_turns_within_a_square();
    what_cannot_be_followed_is_refused();
    a_fast_turn_keeps_its_rate();
    return test_failures != 0;
}
