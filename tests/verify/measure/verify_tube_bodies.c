// Bodies that are not quite the tube that was expected, and lines that are not all seen. Synthetic
// clouds.
#include "tests/verify/measure/tube_trial.h"

#include <string.h>

static const made_scan usual = {
    .radius = 4e-3, .count = 20000, .noise = 0.05e-3, .missing = 0.1, .stray = 0.05};

// from 4.1 to 3.9 mm: followed to its tip, and told
static void a_taper_is_followed(const made_line *line)
{
    for (int k = 0; k < 9; k++) {
        made_scan scan = usual;
        scan.taper = k < 8 ? -0.2e-3 : -0.4e-3;
        scan.seed = 20 + (unsigned long)k;
        scan.noise = k % 2 ? 0.01e-3 : 0.05e-3;
        scan.visible = k & 2 ? M_PI : 0;
        scan.view = made_view(line);
        tube_options o = trial_options(k & 4 ? 4e-3 : NAN);
        tube_trial t = trial_of(line, &scan, &o);
        trial_print("a taper", &t);
        CHECK(t.st == OK);
        status_clear();
        if (t.st == OK) {
            printf("    taper %.4f +- %.4f mm\n", 1e3 * t.report.taper, 1e3 * t.report.taper_sigma);
            CHECK(t.rms < 0.03e-3 && t.tip < 0.1e-3);
            CHECK(fabs(t.report.length - line->length) < 4 * t.report.length_sigma + 0.02e-3);
            CHECK(fabs(t.report.taper - scan.taper) <
                  fmax(6 * t.report.taper_sigma, 0.02 * fabs(scan.taper)));
        }
        trial_free(&t);
    }
    const tube_options o = trial_options(NAN);
    tube_trial t = trial_of(line, &usual, &o);
    CHECK(t.st == OK && t.report.taper == 0);
    status_clear();
    trial_free(&t);
}

int main(void)
{
    static made_line prototype;
    made_line_make(0.12, made_prototype, NULL, &prototype);
    a_taper_is_followed(&prototype);
    return test_failures != 0;
}
