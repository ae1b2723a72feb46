// tests/unit/reports/test_figures.c
#include "reports/figures.h"
#include "tests/test.h"
#include "tests/unit/reports/files.h"
#include "tests/unit/reports/synthetic.h"

#include <unistd.h>

static const char *const names[] = {"section",   "segment", "segment_stress", "rods",
                                    "curvature", "wrench",  "tendons",        "time_error"};

// the first bytes of a PNG and the size in its header: two pixels to the point
static void check_png(const char *dir, const char *name)
{
    char file[64];
    size_t length = 0;
    (void)snprintf(file, sizeof file, "%s.png", name);
    char *png = whole_file(dir, file, &length);
    CHECK(png && length > 10000 && memcmp(png, "\x89PNG\r\n\x1a\n", 8) == 0);
    if (png && length > 24) {
        const unsigned char *h = (const unsigned char *)png + 16;
        const int width = h[0] << 24 | h[1] << 16 | h[2] << 8 | h[3];
        CHECK(width >= 1800 && width <= 3000);
    }
    free(png);
}

static const char *within(const char *data, size_t length, const char *word)
{
    const size_t n = strlen(word);
    for (size_t i = 0; data && i + n <= length; i++) {
        if (memcmp(data + i, word, n) == 0) {
            return data + i;
        }
    }
    return NULL;
}

// as large as the SVG, letters within, no time of writing
static void check_pdf(const char *dir, const char *name)
{
    char file[64];
    size_t length = 0;
    double mm[2] = {0}, points[2] = {0};
    (void)snprintf(file, sizeof file, "%s.svg", name);
    char *svg = whole_file(dir, file, &length);
    const char *size = svg ? strstr(svg, "width=\"") : NULL;
    CHECK(size && sscanf(size, "width=\"%lfmm\" height=\"%lfmm\"", &mm[0], &mm[1]) == 2);
    free(svg);
    (void)snprintf(file, sizeof file, "%s.pdf", name);
    char *pdf = whole_file(dir, file, &length);
    CHECK(pdf && length > 10000 && memcmp(pdf, "%PDF-1.", 7) == 0);
    const char *box = within(pdf, length, "/MediaBox");
    CHECK(!within(pdf, length, "Date") && within(pdf, length, "/FontFile"));
    CHECK(box && sscanf(box, "/MediaBox [ 0 0 %lf %lf", &points[0], &points[1]) == 2);
    for (int d = 0; d < 2; d++) {
        CHECK_NEAR(points[d] * 25.4 / 72, mm[d], 1e-5 * mm[d]); // six decimals of a point
    }
    CHECK(mm[0] <= 180 + 1e-9);
    free(pdf);
}

static void check_svg(const char *dir, const char *name)
{
    char file[64], start[80];
    size_t length = 0;
    (void)snprintf(file, sizeof file, "%s.svg", name);
    char *svg = whole_file(dir, file, &length);
    CHECK(svg && length > 10000 && length < 2000000);
    if (svg) {
        CHECK(well_formed(svg));
        CHECK(ids_are_unique(svg));
        CHECK(count_of(svg, "<title>") == 1);
        // every id is this picture's own, so that pictures live together in one page
        (void)snprintf(start, sizeof start, " id=\"%s-", name);
        CHECK(count_of(svg, " id=\"") > 0 && count_of(svg, " id=\"") == count_of(svg, start));
        (void)snprintf(start, sizeof start, "href=\"#%s-", name);
        CHECK(count_of(svg, "href=\"#") > 0 && count_of(svg, "href=\"#") == count_of(svg, start));
        CHECK(count_of(svg, "nan") == 0 && count_of(svg, "inf ") == 0);
    }
    free(svg);
}

static void every_figure_is_written(double turns, int nsolution, const char *dir)
{
    run_result r = {0};
    CHECK_OK(synthetic_make(nsolution, turns, -0.5, &r));
    CHECK_OK(figures_all(&r, dir));
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        check_svg(dir, names[i]);
        check_png(dir, names[i]);
        check_pdf(dir, names[i]);
    }
    synthetic_free(&r);
}

// a load of nonsense is drawn as nonsense, and soon: no loop, no failure of cairo
static void numbers_beyond_paper_do_no_harm(void)
{
    char dir[64];
    scratch_make(dir);
    static const double values[] = {1e308, NAN, 1e9, 1e160, INFINITY};
    for (int i = 0; i < (test_is_long() ? 5 : 2); i++) {
        run_result r = {0};
        CHECK_OK(synthetic_loaded_make(2, 0.4, -0.5, LOADS, &r));
        r.segment.load[0].displacement[7] = values[i];
        r.segment.load[0].point[0] = values[i];
        r.section.station[0].centres.stiffness_centre[0] = values[i];
        r.rod.run[0].shape[3].p.a[0] = values[i];
        r.rod.run[0].curvature[3][0] = values[i];
        r.rod.run[1].wrench[2].a[4] = values[i];
        r.rod.run[1].along[5] = values[i];
        r.rod.run[1].load[0] = values[i];
        r.rod.load_sketch[2].force[3].a[0] = values[i];
        r.rod.load_sketch[0].to = values[i];
        r.rod.load_sketch[3].acceleration.a[1] = values[i];
        r.rod.tendon_path[7][1] = values[i];
        (void)alarm(60);
        CHECK_OK(figures_all(&r, dir));
        (void)alarm(0);
        synthetic_free(&r);
    }
    scratch_free(dir);
}

// in one process, where cairo goes on counting its surfaces
static void a_rerun_gives_the_same_bytes(void)
{
    char first[64], second[64];
    scratch_make(first);
    scratch_make(second);
    if (test_is_long()) {
        every_figure_is_written(0, 6, first);
    }
    every_figure_is_written(1, 5, first);
    every_figure_is_written(1, 5, second);
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        char file[64];
        (void)snprintf(file, sizeof file, "%s.svg", names[i]);
        CHECK(same_file(first, second, file));
        (void)snprintf(file, sizeof file, "%s.png", names[i]);
        CHECK(same_file(first, second, file));
        (void)snprintf(file, sizeof file, "%s.pdf", names[i]);
        CHECK(same_file(first, second, file));
    }
    scratch_free(first);
    scratch_free(second);
}

static void parts_that_are_not_there_make_no_picture(void)
{
    const run_result nothing = {0};
    char dir[64];
    size_t length = 0;
    scratch_make(dir);
    CHECK_OK(figures_all(&nothing, dir));
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        char file[64];
        (void)snprintf(file, sizeof file, "%s.svg", names[i]);
        CHECK(whole_file(dir, file, &length) == NULL);
    }
    scratch_free(dir);
}

// rods without a bend, a homogeneous section, bytes that are no text, more solutions than a legend
// holds
static void odd_results_are_drawn(void)
{
    run_result r = {0};
    char dir[64];
    scratch_make(dir);
    CHECK_OK(synthetic_make(40, 0.3, -1e-4, &r));
    (void)snprintf(r.title, sizeof r.title, "\xff\xfe caf\xc3\xa9 \x1b[31m %s",
                   "long long long long long long long title");
    (void)snprintf(r.rod.tendon_name[1], sizeof r.rod.tendon_name[1], "cut \xc3");
    r.section.station[0].centres.isotropic = true;
    r.section.nstation = 1;
    for (int k = 0; k < r.rod.npoint; k++) {
        r.rod.run[0].shape[k] = (pose){mat3_identity(), {{0, 0, r.rod.run[0].s[k]}}};
    }
    r.rod.run[0].tension[0] = 0;
    CHECK_OK(figures_all(&r, dir));
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        check_svg(dir, names[i]);
    }
    scratch_free(dir);
    synthetic_free(&r);
}

// the tips of a sweep have a picture of their own, which others do not; loads are drawn
static void sweeps_and_loads_are_drawn(void)
{
    run_result r = {0};
    char dir[64];
    size_t length = 0;
    scratch_make(dir);
    CHECK_OK(synthetic_loaded_make(7, 0.3, -0.5, LOADS, &r));
    CHECK_OK(figure_rods(&r, dir));
    CHECK_OK(figure_sweep(&r, dir));
    CHECK(whole_file(dir, "sweep.svg", &length) == NULL);
    check_svg(dir, "rods");
    char *loaded = whole_file(dir, "rods.svg", &length);
    for (int i = 0; i < r.rod.nsolution; i++) {
        memset(r.rod.run[i].load, 0, LOADS * sizeof(double));
    }
    CHECK_OK(figure_rods(&r, dir));
    char *bare = whole_file(dir, "rods.svg", &length);
    CHECK(loaded && bare && count_of(loaded, "<path") > count_of(bare, "<path") + 4 * 3);
    free(loaded);
    free(bare);
    synthetic_free(&r);

    CHECK_OK(synthetic_loaded_make(120, 0.3, -0.5, LOADS, &r));
    r.rod.run[30].fraction = 0.5;
    r.rod.run[40].stable = 0;
    CHECK_OK(figure_rods(&r, dir));
    CHECK_OK(figure_sweep(&r, dir));
    check_svg(dir, "sweep");
    check_png(dir, "sweep");
    check_svg(dir, "rods");
    char *rods = whole_file(dir, "rods.svg", &length);
    CHECK(rods && strstr(rods, "rod for 24 of 120 solutions, spread over the sweep</title>"));
    free(rods);
    synthetic_free(&r);
    scratch_free(dir);
}

static void a_picture_that_cannot_be_written_says_so(void)
{
    run_result r = {0};
    CHECK_OK(synthetic_make(2, 1, -0.5, &r));
    CHECK(figure_rods(&r, "/nonexistent/directory") == ERR_RESOURCE);
    CHECK(strstr(status_message(), "rods.svg") != NULL);
    status_clear();
    synthetic_free(&r);
}

int main(void)
{
    a_rerun_gives_the_same_bytes();
    parts_that_are_not_there_make_no_picture();
    odd_results_are_drawn();
    sweeps_and_loads_are_drawn();
    numbers_beyond_paper_do_no_harm();
    a_picture_that_cannot_be_written_says_so();
    return test_failures != 0;
}
