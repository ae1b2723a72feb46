// tests/unit/reports/test_page.c
#include "reports/figures.h"
#include "tests/test.h"
#include "tests/unit/reports/files.h"
#include "tests/unit/reports/synthetic.h"

static char *page_of(const run_result *r, const char *dir)
{
    size_t length = 0;
    CHECK_OK(report_page(r, dir));
    char *page = whole_file(dir, "report.html", &length);
    CHECK(page && strlen(page) == length);
    return page ? page : calloc(1, 1);
}

static void put_picture(const char *dir, const char *name)
{
    char path[128];
    (void)snprintf(path, sizeof path, "%s/%s.svg", dir, name);
    FILE *f = fopen(path, "w");
    CHECK(f && fputs("<svg></svg>\n", f) >= 0 && fclose(f) == 0);
}

static void one_file_holds_everything(void)
{
    run_result r = {0};
    char dir[64];
    scratch_make(dir);
    CHECK_OK(synthetic_make(6, 1, -0.5, &r));
    CHECK_OK(figures_all(&r, dir));
    char *page = page_of(&r, dir);
    CHECK(strncmp(page, "<!DOCTYPE html>", 15) == 0);
    CHECK(well_formed(page));
    CHECK(ids_are_unique(page));
    // what has very many pieces stands there as points
    CHECK(count_of(page, "<svg") + count_of(page, "<img alt=") == 10 &&
          count_of(page, "<?xml") == 0);
    // nothing from outside: the only addresses are the names of the SVG's vocabularies
    CHECK(count_of(page, "http://") == count_of(page, "\"http://www.w3.org/"));
    CHECK(count_of(page, "https:") == 0);
    CHECK(count_of(page, "src=") == count_of(page, "src=\"data:image/png;base64,") &&
          count_of(page, "@import") == 0);
    CHECK(count_of(page, "<table>") == count_of(page, "</table>") &&
          count_of(page, "<table>") >= 5);
    free(page);
    scratch_free(dir);
    synthetic_free(&r);
}

static void words_of_the_user_stay_words(void)
{
    run_result r = {0};
    char dir[64];
    scratch_make(dir);
    CHECK_OK(synthetic_make(4, 1, -0.5, &r));
    char *page = page_of(&r, dir);
    // ours: a scene of the rod, one of the segment, three.js packed and what draws
    CHECK(count_of(page, "<script") == 4 && count_of(page, "</script") == 4);
    CHECK(count_of(page, "<script>alert") == 0);
    CHECK(count_of(page, "&lt;script&gt;alert(1)&lt;/script&gt; tube &amp; &quot;tendons&quot;") ==
          2);
    CHECK(count_of(page, "&lt;script&gt;alert(&#39;x&#39;)") == 1); // the case's own text
    CHECK(count_of(page, "<b>&amp;") == 0 && count_of(page, "left &lt;b&gt;&amp;") >= 2);
    CHECK(count_of(page, "stiff <i>") == 0);
    CHECK(count_of(page, "3D &lt;FEM&gt;") == 1);
    CHECK(well_formed(page));
    free(page);
    scratch_free(dir);
    synthetic_free(&r);
}

static void strains_past_linear_are_pointed_out(void)
{
    run_result r = {0};
    char dir[64];
    scratch_make(dir);
    CHECK_OK(synthetic_make(4, 0, -0.5, &r));
    r.rod.run[1].largest_strain = 0.0501; // soft is linear up to 0.05
    char *page = page_of(&r, dir);
    CHECK(
        count_of(
            page,
            "1 of 4 shapes strain the section by more than what keeps soft close to linear, 5 %") ==
        1);
    CHECK(count_of(page, "<td class=\"bad\">5.01 ⚠</td>") == 1);
    free(page);
    r.rod.run[1].largest_strain = 0.0499;
    page = page_of(&r, dir);
    CHECK(count_of(page, "⚠") == 0 && count_of(page, "close to linear (soft: 5 %)") == 1);
    free(page);
    r.materials[0].linear_strain = r.materials[1].linear_strain = 0;
    page = page_of(&r, dir);
    CHECK(count_of(page, "⚠") == 0 && count_of(page, "does not say up to which strain") == 1);
    free(page);
    scratch_free(dir);
    synthetic_free(&r);
}

static void loads_and_equilibria_are_told(void)
{
    run_result r = {0};
    char dir[64];
    scratch_make(dir);
    CHECK_OK(synthetic_loaded_make(4, 0, -0.5, LOADS, &r));
    struct rod_run *run = r.rod.run;
    char *page = page_of(&r, dir);
    CHECK(well_formed(page) && count_of(page, "Rod under its tendons and loads</h2>") == 1);
    CHECK(count_of(page, "tip &lt;force&gt;</td><td>120</td><td>0.02, 0, 0</td>") == 1);
    CHECK(count_of(page, "wind</td><td>60</td><td>0, 0.1, 0</td>") == 1); // from there ...
    CHECK(count_of(page, "<td>120</td><td>0, 0.34, 0</td>") == 1);        // ... to here
    CHECK(count_of(page, "0, 0, −9.81 m/s²") == 1);
    CHECK(count_of(page, "turning with the section") == 1);
    CHECK(count_of(page, "limit point") == 0 && count_of(page, "unstable") == 0);
    CHECK(count_of(page, "No gravity") == 0);
    free(page);

    run[1].fraction = 0.63;
    run[1].ncritical = 1;
    run[1].critical[0] = (rod_critical){CRITICAL_LIMIT, 0.63, 1};
    run[2].stable = 0;
    run[3].stable = -1;
    run[3].eigenvalue = run[3].energy = run[3].work = NAN;
    run[0].relative_error = 0.0101;
    run[2].relative_error = 0.0099;
    run[2].energy = 1e-3;
    run[2].work = 0.9e-3;
    page = page_of(&r, dir);
    CHECK(count_of(page, "1 of 4 solutions stop at a limit point") == 1);
    CHECK(count_of(page, "<td class=\"bad\">0.63000 ⚠</td>") == 1);
    CHECK(count_of(page, "<small>limit point at 0.63000</small>") == 1);
    CHECK(count_of(page, "1 of 4 solutions are unstable") == 1);
    CHECK(count_of(page, "<td>not known</td><td>–</td>") == 1);
    CHECK(count_of(page, "<td class=\"bad\">0.010 ⚠</td>") == 1);
    CHECK(count_of(page, "<td>1000.0</td><td>900.00</td><td>0.10</td>") == 1);
    free(page);
    scratch_free(dir);
    synthetic_free(&r);
}

static void found_tensions_and_slack_are_told(void)
{
    run_result r = {0};
    char dir[64];
    scratch_make(dir);
    CHECK_OK(synthetic_make(4, 0, -0.5, &r));
    r.rod.run[0].pull[0] = 2e-3;
    r.rod.run[0].pull[1] = -1e-3; // let go: slack, since its tension is 0
    char *page = page_of(&r, dir);
    CHECK(count_of(page, "<td>0.33<small>drawn 2 mm</small></td>") == 1);
    CHECK(count_of(page, "<td>slack<small>drawn −1 mm</small></td>") == 1);
    free(page);
    scratch_free(dir);
    synthetic_free(&r);
}

// the page keeps to a table that can be read, and says where the rest is
static void a_sweep_is_no_wall_of_numbers(void)
{
    run_result r = {0};
    char dir[64];
    scratch_make(dir);
    CHECK_OK(synthetic_make(200, 0, -0.5, &r));
    CHECK_OK(figures_all(&r, dir));
    char *page = page_of(&r, dir);
    CHECK(count_of(page, "20 of 200 solutions, at equal steps; all are in rods.csv") == 1);
    CHECK(count_of(page, "<tr><td>1</td><td>0.33</td>") == 1);
    CHECK(count_of(page, "<tr><td>200</td><td>0</td><td>33</td>") == 1);
    CHECK(count_of(page, "<tr><td>2</td><td>0.66</td>") == 0);
    CHECK(count_of(page, "Tip, bend and strain along the sweep.") == 1);
    free(page);
    scratch_free(dir);
    synthetic_free(&r);
}

static void the_paper_is_cited_for_its_own_figure_only(void)
{
    run_result r = {0};
    char dir[64];
    scratch_make(dir);
    CHECK_OK(synthetic_make(4, 0, -0.5, &r));
    char *page = page_of(&r, dir);
    CHECK(count_of(page, "paper: 10.7°") == 1 &&
          count_of(page, "cannot all come from one linear run") == 1);
    free(page);
    r.segment_length = 30e-3;
    page = page_of(&r, dir);
    CHECK(count_of(page, "paper: ") == 0 && count_of(page, "cannot all come") == 0);
    free(page);
    scratch_free(dir);
    synthetic_free(&r);
}

static void verdicts_are_counted(void)
{
    run_result r = {0};
    char dir[64];
    scratch_make(dir);
    CHECK_OK(synthetic_make(4, 0, -0.5, &r));
    char *page = page_of(&r, dir);
    CHECK(count_of(page, "✓ agrees") == 1 && count_of(page, "✗ out of tolerance") == 1);
    CHECK(count_of(page, ">skipped<") == 1 && count_of(page, "not on this machine") == 1);
    CHECK(count_of(page, "<dd>out of tolerance") == 1);
    free(page);
    r.compare[1].ok = true;
    page = page_of(&r, dir);
    CHECK(count_of(page, "<dd>all agree") == 1);
    free(page);
    scratch_free(dir);
    synthetic_free(&r);
}

// what lies nowhere is not marked on the section's picture: a path of no numbers is an error of the
// page, which browsers tell
static void marks_of_no_numbers_are_left_out(void)
{
    static const double hostile[] = {NAN, INFINITY};
    run_result r = {0};
    char dir[64];
    scratch_make(dir);
    CHECK_OK(synthetic_make(1, 0, -0.5, &r));
    put_picture(dir, "section");
    const double x = r.section_mesh.xyz[0];
    for (int i = 0; i < 2; i++) {
        char *page = page_of(&r, dir);
        CHECK(count_of(page, "<g class=\"over\"") == 9); // materials, axes, centres, tendons
        free(page);
        r.section.station[0].centres.shear_centre[0] = hostile[i];
        page = page_of(&r, dir);
        CHECK(count_of(page, "<g class=\"over\"") == 8);
        CHECK(count_of(page, "\"nan") + count_of(page, "\"inf") == 0);
        free(page);
        r.section.station[0].centres.shear_centre[0] = 0;
        r.section_mesh.xyz[0] = hostile[i];
        page = page_of(&r, dir);
        CHECK(count_of(page, "<g class=\"over\"") == 0);
        free(page);
        r.section_mesh.xyz[0] = x;
    }
    scratch_free(dir);
    synthetic_free(&r);
}

static void a_result_of_nothing_is_a_page_too(void)
{
    const run_result nothing = {0};
    char dir[64];
    scratch_make(dir);
    char *page = page_of(&nothing, dir);
    CHECK(well_formed(page));
    CHECK(count_of(page, "untitled case") == 2 && count_of(page, "id=\"rod\"") == 0);
    free(page);
    scratch_free(dir);
    CHECK(report_page(&nothing, "/nonexistent/directory") == ERR_RESOURCE);
    status_clear();
}

int main(void)
{
    one_file_holds_everything();
    words_of_the_user_stay_words();
    strains_past_linear_are_pointed_out();
    loads_and_equilibria_are_told();
    found_tensions_and_slack_are_told();
    a_sweep_is_no_wall_of_numbers();
    the_paper_is_cited_for_its_own_figure_only();
    verdicts_are_counted();
    marks_of_no_numbers_are_left_out();
    a_result_of_nothing_is_a_page_too();
    return test_failures != 0;
}
