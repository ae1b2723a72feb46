// tests/unit/reports/test_measured.c
// Measured shapes: through the store and back, in JSON, CSV, figures and page; what is made is
// called synthetic everywhere, and the paper's errors stand only where they belong.
#include "reports/measured_show.h"

#include "reports/figures.h"
#include "tests/test.h"
#include "tests/unit/reports/files.h"
#include "tests/unit/reports/synthetic.h"

enum { POINTS = 41 };

static status fill_line(const run_result *r, int solution, measured_line *line)
{
    status st = OK;
    TRY(measured_line_room(line, POINTS));
    (void)snprintf(line->name, sizeof line->name, "shape <%d>", solution + 1);
    (void)snprintf(line->file, sizeof line->file, "%d.csv", solution + 1);
    line->solution = solution;
    line->tip = solution == 0;
    line->turn_free = solution == 1;
    line->better = solution == 0 ? 2 : -1;
    line->better_rms = solution == 0 ? 1e-5 : NAN;
    line->error = (shape_error){.to = 0.12,
                                .longer = -1e-4,
                                .tip = line->tip ? 1.25e-3 : NAN,
                                .tip_sigma = line->tip ? 0.05e-3 : NAN,
                                .tip_angle = line->tip ? 0.1 : NAN,
                                .tip_angle_sigma = NAN,
                                .shape = 0.016,
                                .shape_sigma = NAN,
                                .mean = 5e-4,
                                .rms = 6e-4,
                                .largest = 1.3e-3,
                                .at = 0.11,
                                .base = 4e-5};
    for (int k = 0; k < POINTS; k++) {
        const struct rod_run *run = &r->rod.run[solution];
        const vec3 p = run->shape[2 * k].p;
        line->s[k] = run->s[2 * k];
        line->model[k] = p;
        line->p[k] = vec3_add(p, (vec3){{1e-4 * k, 0, 1e-5}});
        line->sigma[k] = k % 2 ? 5e-5 : NAN;
        line->bend[k] = k > 5 && k < 35 ? (vec3){{10, 1, 0}} : (vec3){{NAN, NAN, NAN}};
        line->bend_sigma[k] = k > 5 && k < 35 ? 0.5 : NAN;
    }

done:
    return st;
}

static status make(bool synthetic, run_result *r)
{
    status st = OK;
    TRY(synthetic_make(3, 1, -0.5, r));
    r->has_measured = true;
    r->measured.synthetic = synthetic;
    r->measured.window = 0.015;
    (void)snprintf(r->measured.source, sizeof r->measured.source, "a bench & more");
    TRY(TAKE(r->measured.line, 2));
    r->measured.nline = 2;
    TRY(fill_line(r, 0, &r->measured.line[0]));
    TRY(fill_line(r, 1, &r->measured.line[1]));

done:
    return st;
}

// synthetic_free leaves what it did not make
static void drop(run_result *r)
{
    measured_result_free(&r->measured);
    synthetic_free(r);
}

static bool same(size_t n, const void *a, const void *b)
{
    return memcmp(a, b, n) == 0;
}

static void the_store_gives_them_back(void)
{
    run_result r = {0}, back = {0};
    char dir[64], path[80];
    scratch_make(dir);
    CHECK_OK(make(true, &r));
    (void)snprintf(path, sizeof path, "%s/result.hdf", dir);
    CHECK_OK(result_store_write(&r, path));
    CHECK_OK(result_store_read(path, &back));
    const measured_result *a = &r.measured, *b = &back.measured;
    CHECK(back.has_measured && b->synthetic && b->nline == 2 && strcmp(a->source, b->source) == 0);
    for (int i = 0; i < 2 && b->nline == 2; i++) {
        const measured_line *x = &a->line[i], *y = &b->line[i];
        CHECK(strcmp(x->name, y->name) == 0 && strcmp(x->file, y->file) == 0);
        CHECK(x->solution == y->solution && x->tip == y->tip && y->npoint == POINTS);
        CHECK(x->error.shape == y->error.shape && x->error.at == y->error.at);
        CHECK(isnan(x->error.tip) == isnan(y->error.tip));
        CHECK(same(sizeof *x->p * POINTS, x->p, y->p));
        CHECK(same(sizeof *x->model * POINTS, x->model, y->model));
        CHECK(same(sizeof *x->s * POINTS, x->s, y->s));
        CHECK(y->turn_free == x->turn_free && y->better == x->better);
        CHECK(i == 0 ? y->better_rms == 1e-5 : isnan(y->better_rms));
        CHECK(isnan(y->sigma[0]) && y->sigma[1] == 5e-5 && y->bend[20].a[0] == 10);
    }
    run_result_free(&back);
    scratch_free(dir);
    drop(&r);
}

static void damaged_ones_are_refused(void)
{
    for (int kind = 0; kind < 5; kind++) {
        run_result r = {0}, back = {0};
        char dir[64], path[80];
        scratch_make(dir);
        CHECK_OK(make(true, &r));
        measured_line *line = &r.measured.line[1];
        line->solution = kind == 0 ? r.rod.nsolution : line->solution;
        line->p[3].a[1] = kind == 1 ? INFINITY : 0;
        line->error.shape = kind == 2 ? NAN : 0.01;
        r.measured.paper = kind == 3 ? 7 : 0;
        line->npoint = kind == 4 ? 1 : POINTS;
        (void)snprintf(path, sizeof path, "%s/result.hdf", dir);
        if (result_store_write(&r, path) == OK) {
            CHECK(result_store_read(path, &back) == ERR_FILE);
            CHECK(strstr(status_message(), "measured") != NULL);
        }
        status_clear();
        run_result_free(&back);
        scratch_free(dir);
        drop(&r);
    }
}

static int occurrences(const char *dir, const char *file, const char *word)
{
    size_t length = 0;
    char *text = whole_file(dir, file, &length);
    const int n = text ? count_of(text, word) : -1;
    free(text);
    return n;
}

// in every table, figure and page, and nowhere where it is measured
static void what_is_made_is_called_so(bool synthetic)
{
    run_result r = {0};
    char dir[64];
    size_t length = 0;
    scratch_make(dir);
    CHECK_OK(make(synthetic, &r));
    CHECK_OK(result_csv(&r, dir));
    CHECK_OK(figures_all(&r, dir));
    CHECK_OK(report_page(&r, dir));
    const char *const files[] = {"measured.csv", "measured_shapes.csv", "report.html"};
    for (int i = 0; i < 3; i++) {
        CHECK((occurrences(dir, files[i], "ynthetic") > 0) == synthetic);
    }
    CHECK((occurrences(dir, "measured.svg", "synthetic") > 0) == synthetic);
    CHECK((occurrences(dir, "measured_along.svg", "synthetic") > 0) == synthetic);
    CHECK(occurrences(dir, "measured.csv", "\n") == 3);
    CHECK(occurrences(dir, "measured_shapes.csv", "\n") == 1 + 2 * POINTS);
    char *page = whole_file(dir, "report.html", &length);
    CHECK(page && strstr(page, "id=\"measured\"") && well_formed(page));
    CHECK(strstr(page, "shape &lt;1&gt;") && strstr(page, "a bench &amp; more"));
    CHECK(strstr(page, "free in its turn about z") &&
          strstr(page, "lies far nearer to solution 3"));
    CHECK(strstr(page, "1.60 *") != NULL); // no uncertainty of what a choice decides
    CHECK(strstr(page, "1.25 ± 0.05 (1.0)") && strstr(page, "not measured"));
    free(page);
    scratch_free(dir);
    drop(&r);
}

// Table II at 0.67 N: 2.03 mm and 2.3 % for the tendon at 0, 1.99 mm for the one at pi
static void the_paper_stands_where_it_belongs(void)
{
    run_result r = {0};
    measured_row rows[MEASURED_ROWS];
    CHECK_OK(make(true, &r));
    CHECK(r.rod.ntendon == 2);
    for (int i = 0; i < r.rod.nsolution; i++) {
        r.rod.run[i].tension[0] = r.rod.run[i].tension[1] = 0;
    }
    r.rod.tendon_base[0][0] = 3.6e-3;
    r.rod.tendon_base[1][0] = -3.6e-3;
    r.rod.tendon_base[0][1] = r.rod.tendon_base[1][1] = 0;
    r.rod.run[0].tension[0] = 0.67;
    r.rod.run[1].tension[0] = 0.68; // none of the paper's
    r.rod.run[2].tension[1] = 0.67;
    CHECK(!paper_error_of(&r, 0)); // the case names no table
    CHECK(measured_rows(&r, rows) == 2 && !measured_has_paper(&r));
    r.measured.paper = PAPER_TABLE_2;
    CHECK(paper_error_of(&r, 0) && paper_error_of(&r, 0)->tip_mm == 2.03);
    CHECK(paper_error_of(&r, 0) && paper_error_of(&r, 0)->shape_percent == 2.3);
    CHECK(!paper_error_of(&r, 1));
    CHECK(paper_error_of(&r, 2) && paper_error_of(&r, 2)->tip_mm == 1.99);
    // the third solution was not measured: the paper's errors alone
    CHECK(measured_rows(&r, rows) == 3);
    const measured_cells c = measured_cells_of(&r, &rows[2], " +- ");
    CHECK(strcmp(c.tip, "not published") == 0 && strcmp(c.paper_tip, "1.99 (1.7)") == 0);
    r.rod.run[0].tension[1] = 0.1; // both tendons
    CHECK(!paper_error_of(&r, 0));
    r.measured.paper = PAPER_TABLE_3;
    CHECK(!paper_error_of(&r, 2));
    drop(&r);
}

int main(void)
{
    the_store_gives_them_back();
    damaged_ones_are_refused();
    what_is_made_is_called_so(true);
    what_is_made_is_called_so(false);
    the_paper_stands_where_it_belongs();
    return test_failures != 0;
}
