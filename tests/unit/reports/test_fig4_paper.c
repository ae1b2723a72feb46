// tests/unit/reports/test_fig4_paper.c
#include "reports/fig4_paper.h"
#include "tests/test.h"
#include "tests/unit/reports/synthetic.h"

static void only_the_paper_s_segment_gets_the_paper_s_numbers(void)
{
    run_result r = {0};
    CHECK_OK(make_segment(&r, -0.5));
    CHECK(!fig4_is(&r)); // the same segment, but nobody asked for the figure
    (void)snprintf(r.title, sizeof r.title, "Fig. 4: loads");
    CHECK(fig4_is(&r));
    CHECK(fig4_which(&r, 0) == FIG4_AT_GC && fig4_which(&r, 1) == FIG4_AT_NC);
    CHECK(fig4_paper(FIG4_AT_GC).tip_angle != NULL && fig4_paper(FIG4_AT_GC).shortening == NULL);
    CHECK(fig4_paper(FIG4_AT_NC).shortening != NULL &&
          fig4_paper(FIG4_AT_NC).mid_curvature == NULL);
    CHECK(fig4_paper(FIG4_NONE).tip_angle == NULL);

    r.segment_length = 10e-3; // as the caption has it
    CHECK(!fig4_is(&r));
    r.segment_length = 20e-3;
    r.segment.nload = 1;
    CHECK(!fig4_is(&r));
    r.segment.nload = 2;
    r.segment.load[1].point[0] = 1e-3;
    CHECK(!fig4_is(&r));
    r.segment.load[1].point[0] = -2.1233e-3;
    r.segment.load[0].force[2] = -0.6;
    CHECK(!fig4_is(&r));
    r.segment.load[0].force[2] = -0.5;
    r.segment.middle.K = mat6_scale(1.1, r.segment.middle.K);
    CHECK(!fig4_is(&r));
    synthetic_free(&r);
}

static void another_load_is_another_figure(void)
{
    run_result r = {0};
    CHECK_OK(make_segment(&r, -0.6));
    CHECK(!fig4_is(&r));
    synthetic_free(&r);
    CHECK_OK(make_segment(&r, 0.5)); // pulls
    CHECK(!fig4_is(&r));
    synthetic_free(&r);
    CHECK(!fig4_is(&r)); // nothing at all
}

// 170.338 / 29.2130 mm^2, against the 7.11 that the paper's three figures need
static void the_note_says_why_they_differ(void)
{
    run_result r = {0};
    char note[600];
    CHECK_OK(make_segment(&r, -0.5));
    fig4_note(&r, note, sizeof note);
    CHECK(strstr(note, "5.83 mm²") && strstr(note, "7.11 mm²") && note[strlen(note) - 1] == '.');
    synthetic_free(&r);
}

int main(void)
{
    only_the_paper_s_segment_gets_the_paper_s_numbers();
    another_load_is_another_figure();
    the_note_says_why_they_differ();
    return test_failures != 0;
}
