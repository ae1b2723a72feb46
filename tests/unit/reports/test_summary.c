// tests/unit/reports/test_summary.c
#include "reports/figures.h"
#include "reports/markup.h"
#include "tests/test.h"
#include "tests/unit/reports/files.h"
#include "tests/unit/reports/synthetic.h"

// the caller's to free
static char *summary_of(const run_result *r, int max_lines)
{
    enum { ROOM = 1 << 15 };
    char *text = calloc(1, ROOM);
    FILE *f = tmpfile();
    if (!text || !f) {
        exit(1);
    }
    CHECK_OK(report_summary(r, max_lines, f));
    rewind(f);
    CHECK(fread(text, 1, ROOM - 1, f) < ROOM - 1);
    (void)fclose(f);
    return text;
}

static int widest_line(const char *text)
{
    int widest = 0;
    char line[1024], clean[1024];
    for (; *text; text += strcspn(text, "\n") + 1) {
        const size_t n = strcspn(text, "\n");
        memcpy(line, text, n);
        line[n] = 0;
        const int columns = (int)utf8_clean(line, clean, sizeof clean);
        widest = columns > widest ? columns : widest;
    }
    return widest;
}

static void it_keeps_to_its_lines_and_columns(void)
{
    run_result r = {0};
    CHECK_OK(synthetic_make(40, 1, -0.5, &r));
    memset(r.title, 'x', sizeof r.title - 1);
    memset(r.rod.tendon_name[0], 'y', sizeof r.rod.tendon_name[0] - 1);
    for (int lines = 0; lines <= 70; lines += 5) {
        char *text = summary_of(&r, lines);
        CHECK(count_of(text, "\n") <= lines);
        CHECK(lines < 15 || count_of(text, "\n") == (lines < 55 ? lines : count_of(text, "\n")));
        CHECK(widest_line(text) <= 100);
        free(text);
    }
    synthetic_free(&r);
}

static void what_is_left_off_is_said(void)
{
    run_result r = {0};
    CHECK_OK(synthetic_make(40, 1, -0.5, &r));
    char *text = summary_of(&r, 25);
    const char *more = strstr(text, "\n         and ");
    CHECK(count_of(text, " bend ") > 3 && more != NULL);
    CHECK(more && atoi(more + 14) + count_of(text, " bend ") == 40);
    free(text);
    synthetic_free(&r);
}

static void its_numbers_carry_units(void)
{
    run_result r = {0};
    CHECK_OK(synthetic_make(4, 0, -0.5, &r));
    r.rod.run[3].largest_strain = 0.07;
    char *text = summary_of(&r, 25);
    CHECK(strstr(text, "EA 29.213 N ") && strstr(text, "GJ 65 N mm^2"));
    CHECK(strstr(text, "stiffness centre (-2.1233, 0.0000) mm"));
    CHECK(strstr(text, "tip angle   7.142 deg"));
    CHECK(strstr(text, "the paper reports: GC 10.7 deg, 9.39 1/m"));
    CHECK(strstr(text, "! 1 of 4 strain soft past its linear 5 %"));
    CHECK(strstr(text, "1 agree, 1 out of tolerance, 1 skipped"));
    CHECK(strstr(text, "OUT: rod: tip"));
    free(text);
    synthetic_free(&r);
}

static void what_is_wrong_with_a_rod_is_marked(void)
{
    run_result r = {0};
    CHECK_OK(synthetic_loaded_make(4, 0, -0.5, LOADS, &r));
    char *text = summary_of(&r, 25);
    CHECK(strstr(text, "limit point") == NULL && strstr(text, "unstable") == NULL);
    CHECK(strstr(text, "under loads") != NULL);
    free(text);
    r.rod.run[1].fraction = 0.625;
    r.rod.run[2].stable = 0;
    r.rod.run[3].relative_error = 0.02;
    r.rod.run[3].pull[0] = -1e-3;
    text = summary_of(&r, 25);
    CHECK(strstr(text, " at 0.625!") && strstr(text, " unstable") && strstr(text, "err 0.02!"));
    CHECK(strstr(text, "1 of 4 stop at a limit point") && strstr(text, "1 of 4 have an estimated"));
    CHECK(strstr(text, "slack 0.66") != NULL);
    free(text);
    r.rod.run[0].load[2] = 0.5;
    text = summary_of(&r, 25);
    CHECK(strstr(text, "times (x) loads") && strstr(text, "0.33 0 x1 x1 x0.5 x1 "));
    free(text);
    synthetic_free(&r);
}

static void small_results_are_seen(void)
{
    run_result r = {0};
    CHECK_OK(synthetic_make(4, 0, -0.5e-6, &r));
    r.rod_length *= 1e-3;
    r.rod.run[0].tip.p = (vec3){{1.5e-6, 0, 2e-6}};
    char *text = summary_of(&r, 25);
    CHECK(strstr(text, "tip angle 7.142e-06 deg") != NULL);
    CHECK(strstr(text, "0.001500") != NULL);
    free(text);
    synthetic_free(&r);
}

static void a_terminal_is_not_commanded(void)
{
    run_result r = {0};
    CHECK_OK(synthetic_make(2, 0, -0.5, &r));
    (void)snprintf(r.title, sizeof r.title, "a\x1b]0;b\x07\xff");
    r.segment.load[0].name = "\x1b[2J";
    char *text = summary_of(&r, 25);
    CHECK(strchr(text, 0x1b) == NULL && strchr(text, 0x07) == NULL &&
          strchr(text, (char)0xff) == NULL);
    free(text);
    synthetic_free(&r);
}

static void a_full_disk_is_noticed(void)
{
    run_result r = {0};
    CHECK_OK(synthetic_make(2, 0, -0.5, &r));
    FILE *full = fopen("/dev/full", "w");
    if (full) {
        CHECK(report_summary(&r, 25, full) == ERR_RESOURCE);
        status_clear();
        (void)fclose(full);
    }
    synthetic_free(&r);
}

int main(void)
{
    it_keeps_to_its_lines_and_columns();
    what_is_left_off_is_said();
    its_numbers_carry_units();
    what_is_wrong_with_a_rod_is_marked();
    small_results_are_seen();
    a_terminal_is_not_commanded();
    a_full_disk_is_noticed();
    return test_failures != 0;
}
