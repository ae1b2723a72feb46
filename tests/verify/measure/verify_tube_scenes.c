// tests/verify/measure/verify_tube_scenes.c
// What scanners and people do to a tube's picture: half of it hidden, gaps, a hand, a base plate,
// tight bends, unknown bases. Synthetic clouds.
#include "tests/verify/measure/tube_trial.h"

static const made_scan usual = {
    .radius = 4e-3, .count = 30000, .noise = 0.05e-3, .missing = 0.3, .stray = 0.05, .seed = 11};

typedef struct scene {
    const char *name;
    made_scan scan;
    tube_options options;
    double rms, tip; // most [mm]
} scene;

static scene scene_of(const char *name, double rms_mm, double tip_mm)
{
    return (scene){name, usual, trial_options(4e-3), rms_mm, tip_mm};
}

static tube_report check_scene(const scene *s, const made_line *line)
{
    tube_trial t = trial_of(line, &s->scan, &s->options);
    trial_print(s->name, &t);
    CHECK(t.st == OK);
    status_clear();
    if (t.st == OK) {
        CHECK_BELOW(t.rms, s->rms * 1e-3);
        CHECK_BELOW(t.tip, s->tip * 1e-3);
        // a given radius leaves the free one to be compared, half of a tube decides it less
        CHECK_BELOW(fabs(t.report.radius_free - s->scan.radius),
                    fmax(0.005 * s->scan.radius, 5 * t.report.radius_free_sigma));
    }
    trial_free(&t);
    return t.report;
}

static void half_of_it_is_seen(const made_line *line)
{
    for (int free_radius = 0; free_radius < 2; free_radius++) {
        scene half = scene_of("180 degrees seen", 0.03, 0.1);
        half.scan.visible = M_PI;
        half.scan.view = made_view(line);
        half.scan.missing = 0;
        half.options.radius = free_radius ? NAN : 4e-3;
        check_scene(&half, line);
        scene third = scene_of("120 degrees seen", 0.03, 0.1);
        third.scan.visible = 2 * M_PI / 3;
        third.scan.view = made_view(line);
        third.scan.missing = 0;
        third.options.radius = free_radius ? NAN : 4e-3;
        check_scene(&third, line);
    }
}

static void gaps_are_bridged(const made_line *line)
{
    scene gap = scene_of("a gap of 10 mm", 0.05, 0.1);
    gap.scan.gap[0] = 55e-3;
    gap.scan.gap[1] = 65e-3;
    gap.scan.missing = 0;
    const tube_report r = check_scene(&gap, line);
    CHECK(r.ngap == 1);
    CHECK_WITHIN(r.gap[0].from, 55e-3, 1e-3);
    CHECK_WITHIN(r.gap[0].to, 65e-3, 1e-3);
    CHECK_BELOW(r.gap[0].angle, 0.6);
    scene near_tip = scene_of("a gap of 8 mm near the tip", 0.05, 0.1);
    near_tip.scan.gap[0] = 107e-3;
    near_tip.scan.gap[1] = 115e-3;
    check_scene(&near_tip, line);
    scene at_base = scene_of("nothing seen of the first 6 mm", 0.05, 0.1);
    at_base.scan.gap[1] = 6e-3;
    check_scene(&at_base, line);
}

static void what_else_is_in_the_picture(const made_line *line)
{
    scene hand = scene_of("a hand", 0.03, 0.1);
    hand.scan.hand = true;
    check_scene(&hand, line);
    hand.options.radius = NAN;
    hand.name = "a hand, radius free";
    check_scene(&hand, line);
    scene plate = scene_of("a base plate", 0.03, 0.1);
    plate.scan.plate = true;
    check_scene(&plate, line);
    plate.name = "a hand, a base plate, half seen";
    plate.scan.hand = true;
    plate.scan.visible = M_PI;
    plate.scan.view = made_view(line);
    plate.scan.missing = 0.1;
    check_scene(&plate, line);
    scene stray = scene_of("40 % stray", 0.03, 0.1);
    stray.scan.stray = 0.4;
    check_scene(&stray, line);
    scene few = scene_of("3000 points", 0.03, 0.15);
    few.scan.count = 3000;
    check_scene(&few, line);
    scene coarse = scene_of("0.2 mm of noise", 0.03, 0.15);
    coarse.scan.noise = 0.2e-3;
    coarse.options.noise = 0.2e-3;
    check_scene(&coarse, line);
    scene fine = scene_of("0.002 mm of noise", 0.03, 0.1);
    fine.scan.noise = 0.002e-3;
    check_scene(&fine, line);
}

static void tips(const made_line *line)
{
    scene flat = scene_of("a flat tip", 0.03, 0.1);
    flat.scan.cap = MADE_FLAT;
    CHECK(check_scene(&flat, line).tip == TUBE_TIP_FLAT);
    scene open = scene_of("an open tip", 0.03, 0.1);
    CHECK(check_scene(&open, line).tip == TUBE_TIP_OPEN);
    // the ball's pole is the tip: a radius beyond the tube's end, where the known line stops
    scene round = scene_of("a round tip", 0.03, 4.1);
    round.scan.cap = MADE_ROUND;
    const tube_report r = check_scene(&round, line);
    CHECK(r.tip == TUBE_TIP_ROUND);
    CHECK_WITHIN(r.length, 124e-3, 0.1e-3);
}

static void shapes(void)
{
    static made_line line;
    const double arc[3] = {226 / 180.0 * M_PI / 0.12, 0, 0};
    made_line_make(0.12, made_arc, arc, &line);
    scene bend = scene_of("226 degrees", 0.03, 0.1);
    check_scene(&bend, &line);
    const double tight[3] = {1.5, 1 / 12e-3, 0};
    made_line_make(0.12, made_bend, tight, &line);
    bend.name = "a bend of 12 mm radius, 86 degrees";
    check_scene(&bend, &line);
    const double none[3] = {0};
    made_line_make(0.12, made_arc, none, &line);
    bend.name = "straight";
    check_scene(&bend, &line);
    made_line_make(0.3, made_prototype, NULL, &line);
    bend.name = "300 mm of 1.5 mm radius";
    bend.scan.radius = 1.5e-3;
    bend.options.radius = 1.5e-3;
    bend.scan.missing = 0.1; // its patches are longer than its gaps may be
    check_scene(&bend, &line);
}

static void less_is_known(const made_line *line)
{
    const vec3 unknown = {{NAN, NAN, NAN}};
    for (int k = 0; k < 6; k++) {
        const char *names[] = {
            "base point alone", "base point alone, radius free", "nothing but radius",
            "nothing known",    "nothing but radius, half seen", "nothing known, half seen"};
        scene s = scene_of(names[k], 0.1, 0.1); // the base end is found as the tip is
        s.options.base_is_plane = false;
        s.options.direction = unknown;
        s.options.base = k < 2 ? s.options.base : unknown;
        s.options.radius = k % 2 ? NAN : 4e-3;
        s.scan.visible = k > 3 ? M_PI : 0;
        s.scan.view = made_view(line);
        s.scan.missing = k > 3 ? 0 : 0.3;
        check_scene(&s, line);
    }
}

int main(void)
{
    against(BY_MADE_DATA, "synthetic clouds of known scenes");
    static made_line prototype;
    made_line_make(0.12, made_prototype, NULL, &prototype);
    half_of_it_is_seen(&prototype);
    gaps_are_bridged(&prototype);
    what_else_is_in_the_picture(&prototype);
    tips(&prototype);
    shapes();
    less_is_known(&prototype);
    return test_failures != 0;
}
