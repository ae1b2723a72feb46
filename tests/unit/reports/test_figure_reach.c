// tests/unit/reports/test_figure_reach.c
// The pictures of a reach study and its view: well formed, the same every time, small however large
// the tissue is, and unharmed by numbers that are none.
#include "reports/figures.h"
#include "reports/page_kit.h"
#include "tests/reach_results.h"
#include "tests/test.h"
#include "tests/unit/reports/files.h"

#include <unistd.h>

static const char *const names[] = {"reach", "reach_clearance", "reach_map", "design"};
enum { NAMES = sizeof names / sizeof *names };

static run_result make(bool hostile)
{
    run_result r = {.title = "where <scopes> reach"};
    CHECK_OK(reach_results_make(hostile, true, true, &r.reach));
    return r;
}

static void check_svg(const char *dir, const char *name)
{
    char file[64];
    size_t length = 0;
    (void)snprintf(file, sizeof file, "%s.svg", name);
    char *svg = whole_file(dir, file, &length);
    CHECK(svg && length > 10000 && length < 400000);
    if (svg) {
        CHECK(well_formed(svg) && ids_are_unique(svg) && count_of(svg, "<title>") == 1);
        CHECK(count_of(svg, "nan") == 0 && count_of(svg, "inf ") == 0);
    }
    free(svg);
}

static void pictures_are_the_same_every_time(void)
{
    char first[64], second[64];
    scratch_make(first);
    scratch_make(second);
    run_result r = make(true);
    CHECK_OK(figures_all(&r, first));
    CHECK_OK(figures_all(&r, second));
    for (int i = 0; i < NAMES; i++) {
        char file[64];
        check_svg(first, names[i]);
        (void)snprintf(file, sizeof file, "%s.svg", names[i]);
        CHECK(same_file(first, second, file));
        (void)snprintf(file, sizeof file, "%s.png", names[i]);
        CHECK(same_file(first, second, file));
        (void)snprintf(file, sizeof file, "%s.pdf", names[i]);
        CHECK(same_file(first, second, file));
    }
    run_result_free(&r);
    scratch_free(first);
    scratch_free(second);
}

// a wall of 100,000 triangles: the egg with every triangle cut into 144
static void make_fine(reach_result *r)
{
    enum { CUTS = 12 };
    const reach_result egg = *r;
    const int each = CUTS * CUTS, corners = 3 * each;
    r->nvertex = corners * egg.ntriangle;
    r->ntriangle = each * egg.ntriangle;
    r->vertex = calloc((size_t)r->nvertex, sizeof *r->vertex);
    r->triangle = calloc((size_t)r->ntriangle, sizeof *r->triangle);
    for (int t = 0; r->vertex && r->triangle && t < r->ntriangle; t++) {
        const int whole = t / each, row = (int)sqrt(t % each), k = t % each - row * row;
        // row `row` of the rows parallel to the side away from corner 0: k even upright, odd on its
        // head
        const int h[3] = {row, row + 1, k % 2 ? row : row + 1};
        const int j[3] = {k / 2, k / 2 + k % 2, k / 2 + 1};
        for (int c = 0; c < 3; c++) {
            const double a = (double)(h[c] - j[c]) / CUTS, b = (double)j[c] / CUTS;
            const int *corner = egg.triangle[whole];
            for (int d = 0; d < 3; d++) {
                r->vertex[3 * t + c][d] = egg.vertex[corner[0]][d] * (1 - (double)h[c] / CUTS) +
                                          egg.vertex[corner[1]][d] * a +
                                          egg.vertex[corner[2]][d] * b;
            }
            r->triangle[t][c] = 3 * t + c;
        }
    }
    free(egg.vertex);
    free(egg.triangle);
}

static void a_fine_wall_makes_no_large_picture(void)
{
    char dir[64];
    size_t length = 0;
    scratch_make(dir);
    run_result r = make(false);
    make_fine(&r.reach);
    CHECK(r.reach.ntriangle > 100000);
    CHECK_OK(figures_all(&r, dir));
    for (int i = 0; i < NAMES; i++) {
        check_svg(dir, names[i]);
    }
    CHECK_OK(report_page(&r, dir));
    char *page = whole_file(dir, "report.html", &length);
    CHECK(page && length < 1900000 && well_formed(page) && ids_are_unique(page));
    free(page);
    run_result_free(&r);
    scratch_free(dir);
}

static void numbers_that_are_none_do_no_harm(void)
{
    static const double values[] = {1e308, NAN};
    char dir[64];
    scratch_make(dir);
    for (size_t i = 0; i < sizeof values / sizeof *values; i++) {
        bytes page = {0};
        run_result r = make(false);
        reach_answer *a = &r.reach.scope[0].answer[0];
        a->point[3][1] = a->room[4] = a->along[5] = a->clearance = a->s = values[i];
        r.reach.target[1][2] = r.reach.map_point[7][0] = r.reach.entry.p.a[1] = values[i];
        r.reach.scope[1].radius = r.reach.scope[2].length = values[i];
        r.reach.design.row[1].score = r.reach.design.row[3].value[0] = values[i];
        r.reach.design.lower[1] = r.reach.design.start_score = values[i];
        r.reach.vertex[9][1] = i == 0 ? r.reach.vertex[9][1] : values[i];
        (void)alarm(60);
        CHECK_OK(page_reach_view(&page, &r));
        CHECK_OK(figures_all(&r, dir));
        (void)alarm(0);
        bytes_free(&page);
        run_result_free(&r);
    }
    scratch_free(dir);
}

static void what_is_not_there_makes_no_picture(void)
{
    char dir[64];
    size_t length = 0;
    bytes page = {0};
    run_result r = {0};
    scratch_make(dir);
    CHECK_OK(figures_all(&r, dir));
    CHECK_OK(page_reach_view(&page, &r));
    CHECK(page.length == 0);
    CHECK_OK(reach_results_make(false, false, false, &r.reach));
    CHECK_OK(figures_all(&r, dir));
    CHECK(!whole_file(dir, "reach_map.svg", &length) && !whole_file(dir, "design.svg", &length));
    check_svg(dir, "reach");
    run_result_free(&r);
    scratch_free(dir);
}

int main(void)
{
    pictures_are_the_same_every_time();
    a_fine_wall_makes_no_large_picture();
    numbers_that_are_none_do_no_harm();
    what_is_not_there_makes_no_picture();
    return test_failures != 0;
}
