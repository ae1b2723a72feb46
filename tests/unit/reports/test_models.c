// tests/unit/reports/test_models.c
// What assumptions about the section cost: through the store and back, in JSON, CSV and the page.
#include "reports/figures.h"
#include "tests/test.h"
#include "tests/unit/reports/files.h"
#include "tests/unit/reports/synthetic.h"

// three laws, the second of which does not apply; the law alone is known
static void fill_models(model_checks *m, bool second)
{
    *m = (model_checks){.there = true, .lengths = {20e-3, second ? 40e-3 : 0}};
    if (!second) {
        (void)snprintf(m->why_no_second, sizeof m->why_no_second, "the section <changes>");
    }
    for (int i = 0; i < 36; i++) {
        m->compliance.a[i / 6][i % 6] = i % 7 ? 1e-3 * (i / 6 + 1) * (i % 6 + 1) : 1 + i;
        m->law_difference.a[i / 6][i % 6] = second && i / 6 >= NZ && i % 6 >= NZ ? 2e-3 * i : NAN;
    }
    for (int k = 0; k < MODEL_CHECKS; k++) {
        model_check *one = &m->model[k];
        (void)snprintf(one->name, sizeof one->name, "model %d", k);
        one->compliance = mat6_scale(1 + 0.01 * k, m->compliance);
        one->error = 0.01 * k;
        one->row = 2;
        one->column = 3 + k % 2;
        one->law_error = second ? 0.02 * k : NAN;
        one->law_row = one->law_column = 5;
    }
    (void)snprintf(m->model[1].why, sizeof m->model[1].why, "not of this material");
}

static bool same_number(double a, double b)
{
    return a == b || (isnan(a) && isnan(b));
}

static void same_models(const model_checks *a, const model_checks *b)
{
    CHECK(a->there == b->there && strcmp(a->why_no_second, b->why_no_second) == 0);
    CHECK(a->lengths[0] == b->lengths[0] && a->lengths[1] == b->lengths[1]);
    for (int i = 0; i < 36; i++) {
        CHECK(a->compliance.a[i / 6][i % 6] == b->compliance.a[i / 6][i % 6]);
        CHECK(same_number(a->law_difference.a[i / 6][i % 6], b->law_difference.a[i / 6][i % 6]));
    }
    for (int k = 0; k < MODEL_CHECKS; k++) {
        const model_check *x = &a->model[k], *y = &b->model[k];
        CHECK(strcmp(x->name, y->name) == 0 && strcmp(x->why, y->why) == 0);
        CHECK(x->error == y->error && same_number(x->law_error, y->law_error));
        CHECK(x->row == y->row && x->column == y->column && x->law_row == y->law_row);
        CHECK(x->compliance.a[4][2] == y->compliance.a[4][2]);
    }
}

static void the_store_gives_them_back(bool second)
{
    run_result r = {0}, back = {0};
    char dir[64], path[80];
    scratch_make(dir);
    CHECK_OK(synthetic_make(2, 1, -0.5, &r));
    fill_models(&r.models, second);
    (void)snprintf(path, sizeof path, "%s/result.hdf", dir);
    CHECK_OK(result_store_write(&r, path));
    CHECK_OK(result_store_read(path, &back));
    same_models(&r.models, &back.models);
    run_result_free(&back);
    scratch_free(dir);
    synthetic_free(&r);
}

static void tables_and_page_tell_them(void)
{
    run_result r = {0};
    char dir[64];
    size_t length = 0;
    scratch_make(dir);
    CHECK_OK(synthetic_make(2, 1, -0.5, &r));
    fill_models(&r.models, false);
    CHECK_OK(result_csv(&r, dir));
    char *table = whole_file(dir, "models.csv", &length);
    CHECK(table && count_of(table, "\n") == 22); // a line of names and the upper triangle
    CHECK(strstr(table, "nx,nx,1,0,,0.02") != NULL);
    CHECK_OK(report_page(&r, dir));
    char *page = whole_file(dir, "report.html", &length);
    CHECK(page && strstr(page, "id=\"models\"") && well_formed(page));
    CHECK(strstr(page, "the section &lt;changes&gt;") != NULL);
    free(page);
    free(table);
    scratch_free(dir);
    synthetic_free(&r);
}

static void json_has_no_number_that_is_none(void)
{
    run_result r = {0};
    char *text = NULL;
    size_t length = 0;
    FILE *stream = open_memstream(&text, &length);
    json *j = NULL;
    CHECK_OK(synthetic_make(2, 1, -0.5, &r));
    fill_models(&r.models, true);
    CHECK_OK(json_open(stream, &j));
    CHECK_OK(result_json_compare(j, NULL, &r));
    CHECK_OK(json_close(j));
    CHECK(fclose(stream) == 0);
    CHECK(strstr(text, "\"models\"") && strstr(text, "\"law_3d\"") && !strstr(text, "nan"));
    CHECK(strstr(text, "\"why_not\": \"not of this material\"") ||
          strstr(text, "\"why_not\":\"not of this material\""));
    free(text);
    synthetic_free(&r);
}

int main(void)
{
    the_store_gives_them_back(true);
    the_store_gives_them_back(false);
    tables_and_page_tell_them();
    json_has_no_number_that_is_none();
    return test_failures != 0;
}
