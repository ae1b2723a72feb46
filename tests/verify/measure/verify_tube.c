// tests/verify/measure/verify_tube.c
// The figures that a scan must reach: a helical tube of 4 mm radius and 120 mm, 0.05 mm noise,
// 30 % missing, 5 % stray. Synthetic clouds.
#include "tests/verify/measure/tube_trial.h"

static const double most_rms = 0.03e-3, most_tip = 0.1e-3, most_radius = 0.02e-3;

static const made_scan usual = {
    .radius = 4e-3, .count = 30000, .noise = 0.05e-3, .missing = 0.3, .stray = 0.05};

static void check_figures(const char *name, const tube_trial *t)
{
    about("%s", name);
    trial_print(name, t);
    CHECK(t->st == OK);
    status_clear();
    if (t->st == OK) {
        CHECK_BELOW(t->rms, most_rms);
        CHECK_BELOW(t->tip, most_tip);
        CHECK_WITHIN(t->report.radius_free, 4e-3, most_radius);
        CHECK_WITHIN(t->report.noise, 0.05e-3, 0.005e-3);
    }
}

static void a_helical_tube_is_found(const char *name, const made_line *line)
{
    for (unsigned long seed = 1; seed <= 4; seed++) {
        for (int given = 0; given < 2; given++) {
            char words[64];
            made_scan scan = usual;
            scan.seed = seed;
            const tube_options o = trial_options(given ? 4e-3 : NAN);
            tube_trial t = trial_of(line, &scan, &o);
            (void)snprintf(words, sizeof words, "%s, seed %lu, radius %s", name, seed,
                           given ? "given" : "free");
            check_figures(words, &t);
            trial_free(&t);
        }
    }
}

int main(void)
{
    against(BY_MADE_DATA, "synthetic clouds of a known line");
    static made_line prototype, helix;
    const double curvature[3] = {28, 0, 25};
    made_line_make(0.12, made_prototype, NULL, &prototype);
    made_line_make(0.12, made_arc, curvature, &helix);
    a_helical_tube_is_found("prototype", &prototype);
    a_helical_tube_is_found("helix", &helix);
    return test_failures != 0;
}
