// tests/unit/reports/test_reach_shown.c
// A reach study in tables, on the page and in the terminal: units in every column, what is
// synthetic and what is the paper's named so, names of a user's that stay words.
#include "base/memory.h"
#include "reports/figures.h"
#include "reports/reach_show.h"
#include "tests/reach_results.h"
#include "tests/unit/io/scratch.h"

#include <string.h>

static run_result make(bool hostile)
{
    run_result r = {.title = "where scopes reach"};
    CHECK_OK(reach_results_make(hostile, true, true, &r.reach));
    return r;
}

// "..._m", "..._rad" and so on, or one of the columns of words
static void check_column(const char *file, const char *name)
{
    static const char *const units[] = {"_m", "_rad", "_N", "_ratio", "_count", "_s"};
    static const char *const words[] = {"scope",        "target",     "verdict", "why",
                                        "thoroughness", "proved",     "kind",    "anatomy",
                                        "best",         "limit_note", "state"};
    const size_t length = strlen(name);
    bool known = strncmp(name, "scope_", 6) == 0 && strcmp(file, "reach_map.csv") == 0;
    for (size_t i = 0; i < sizeof units / sizeof *units; i++) {
        const size_t n = strlen(units[i]);
        known = known || (length > n && strcmp(name + length - n, units[i]) == 0);
    }
    for (size_t i = 0; i < sizeof words / sizeof *words; i++) {
        known = known || strcmp(name, words[i]) == 0;
    }
    CHECK(known);
    if (!known) {
        printf("%s: column %s\n", file, name);
    }
}

// cells of a line, quotes taken care of
static int cells_of(const char *line)
{
    int n = 1;
    bool quoted = false;
    for (; *line && (quoted || *line != '\r'); line++) {
        quoted = *line == '"' ? !quoted : quoted;
        n += *line == ',' && !quoted;
    }
    return n;
}

static int check_table(const scratch *dir, const char *file)
{
    size_t size = 0;
    char *text = read_whole(scratch_file(dir, file).text, &size);
    int rows = -1;
    CHECK(text != NULL);
    const int ncell = text ? cells_of(text) : 0;
    for (const char *line = text; line && *line; rows++) {
        CHECK(cells_of(line) == ncell);
        CHECK(!strstr(line, ",=") && *line != '=');
        const char *end = strstr(line, "\r\n");
        line = end ? end + 2 : NULL;
    }
    char *rest = text ? strstr(text, "\r\n") : NULL;
    if (rest) {
        *rest = '\0';
        for (char *name = strtok_r(text, ",", &rest); name; name = strtok_r(NULL, ",", &rest)) {
            check_column(file, name);
        }
    }
    free(text);
    return rows;
}

static void tables_have_units_and_all_rows(void)
{
    for (int hostile = 0; hostile < 2; hostile++) {
        run_result r = make(hostile);
        const reach_result *a = &r.reach;
        const scratch dir = scratch_make();
        int points = 0, poses = 0;
        for (int i = 0; i < a->nscope * a->ntarget; i++) {
            points += a->scope[i / a->ntarget].answer[i % a->ntarget].npoint;
            poses += a->scope[i / a->ntarget].answer[i % a->ntarget].npath;
        }
        CHECK_OK(result_csv(&r, dir.path));
        CHECK(check_table(&dir, "reach.csv") == a->nscope * a->ntarget);
        CHECK(check_table(&dir, "reach_scopes.csv") == a->nscope);
        CHECK(check_table(&dir, "reach_body.csv") == points && points > 0);
        CHECK(check_table(&dir, "reach_way.csv") == poses && poses > 0);
        CHECK(hostile || check_table(&dir, "reach_map.csv") == a->nmap);
        CHECK(check_table(&dir, "design.csv") == a->design.nrow);
        scratch_remove(&dir);
        run_result_free(&r);
    }
}

static void a_body_is_outside_then_in_the_channel_then_looked_at(void)
{
    run_result r = make(false);
    reach_answer *a = &r.reach.scope[0].answer[0];
    a->point[0][2] = -1e-3;
    a->point[1][2] = 3e-3; // of the channel's 4 mm
    a->point[2][0] = 0.2e-3;
    a->point[2][2] = 3e-3; // off its axis by more than the play
    CHECK(reach_part_of(&r.reach, a, 0) == REACH_OUTSIDE);
    CHECK(reach_part_of(&r.reach, a, 1) == REACH_CHANNEL);
    CHECK(reach_part_of(&r.reach, a, 2) == REACH_LOOKED_AT);
    CHECK(reach_part_of(&r.reach, a, a->npoint - 1) == REACH_LOOKED_AT);
    run_result_free(&r);
}

static char *page_of(const run_result *r)
{
    size_t size = 0;
    const scratch dir = scratch_make();
    CHECK_OK(report_page(r, dir.path));
    char *page = read_whole(scratch_file(&dir, "report.html").text, &size);
    CHECK(page && strlen(page) == size);
    scratch_remove(&dir);
    return page;
}

static int count_of(const char *text, const char *word)
{
    int count = 0;
    for (const char *p = strstr(text, word); p; p = strstr(p + 1, word)) {
        count++;
    }
    return count;
}

static void the_page_tells_it_all(void)
{
    run_result r = make(false);
    char *page = page_of(&r);
    CHECK(count_of(page, "<a href=\"#reach\">") == 1 && count_of(page, "<h2 id=\"reach\">") == 1);
    CHECK(count_of(page, "The anatomy is synthetic") == 1);
    CHECK(count_of(page, "in synthetic anatomy") >= 5); // headline numbers, tables
    CHECK(count_of(page, "<td>14 of 20</td>") == 1 && count_of(page, "<td>18 of 20</td>") == 1);
    CHECK(count_of(page, "where the tip's skin comes within 1 mm of it") == 1);
    CHECK(count_of(page, "as printed in the paper") == 3);
    CHECK(count_of(page, "✓ reached") == 3 && count_of(page, "✗ collision") == 3);
    CHECK(count_of(page, "✗ no way in") == 3 && count_of(page, "✗ failed") == 3);
    CHECK(count_of(page, "<small>proved</small>") == 3);
    CHECK(count_of(page, "tension limited by the strain of soft") == 1);
    CHECK(count_of(page, "ways in to each") == 0 &&
          count_of(page, "a way in to each of them") == 1);
    CHECK(count_of(page, "best found") == 1);
    CHECK(count_of(page, "<table>") == count_of(page, "</table>"));
    free(page);
    r.reach.synthetic = false;
    r.reach.path = REACH_FINAL_POSE;
    page = page_of(&r);
    CHECK(count_of(page, "ynthetic") == 0 && count_of(page, "final poses only") == 1);
    free(page);
    run_result_free(&r);
}

static void hostile_names_stay_words(void)
{
    run_result r = make(true);
    char *page = page_of(&r);
    CHECK(count_of(page, "of 20</td>") == 0); // not asked for
    // the scene, three.js and ours; the scope's name in the scene is no tag
    CHECK(count_of(page, "<script") == 3 && count_of(page, "</script") == 3);
    CHECK(count_of(page, "\\u003c/script>\\u003cscript>alert(1)\\u003c/script>") >= 2);
    CHECK(count_of(page, "<img") == 0);
    CHECK(count_of(page, "&lt;img src=x&gt;") >= 1);
    CHECK(count_of(page, "<b>&</b>") == 0 && count_of(page, "&lt;b&gt;&amp;&lt;/b&gt;") == 1);
    free(page);
    run_result_free(&r);
}

static void the_terminal_gets_the_counts(void)
{
    run_result r = make(false);
    char *text = NULL;
    size_t size = 0;
    FILE *stream = open_memstream(&text, &size);
    CHECK_OK(report_summary(&r, 40, stream));
    (void)fclose(stream);
    CHECK(count_of(text, "6 targets in SYNTHETIC anatomy, final poses and ways in") == 1);
    CHECK(count_of(text, "1 of 6   ") == 3 && count_of(text, "of the wall   clinical") == 1);
    CHECK(count_of(text, "the paper prints 14 and 18 of 20") == 1);
    CHECK(count_of(text, "design   helical 5 targets, at the start 4; 80 evaluations, seed 1") ==
          1);
    free(text);
    run_result_free(&r);
}

static void a_start_without_an_answer_is_told(void)
{
    run_result r = make(false);
    char *text = NULL;
    size_t size = 0;
    r.reach.design.start_goal = r.reach.design.start_score = NAN;
    FILE *stream = open_memstream(&text, &size);
    CHECK_OK(report_summary(&r, 40, stream));
    (void)fclose(stream);
    CHECK(count_of(text, "at the start no answer") == 1 && count_of(text, "nan") == 0);
    free(text);
    text = page_of(&r);
    CHECK(count_of(text, "<td>no answer</td>") == 1 && count_of(text, ">nan") == 0);
    free(text);
    run_result_free(&r);
}

int main(void)
{
    a_body_is_outside_then_in_the_channel_then_looked_at();
    tables_have_units_and_all_rows();
    the_page_tells_it_all();
    hostile_names_stay_words();
    the_terminal_gets_the_counts();
    a_start_without_an_answer_is_told();
    return test_failures != 0;
}
