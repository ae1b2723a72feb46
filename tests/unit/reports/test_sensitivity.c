// What moves the answer: through the store and back, on the page, and files that are damaged.
#include "reports/figures.h"
#include "tests/test.h"
#include "tests/unit/reports/files.h"
#include "tests/unit/reports/synthetic.h"

enum { MOVERS = 2, SOLUTIONS = 2 };

static void fill(run_result *r)
{
    sensitivity_result *s = &r->sensitivity;
    CHECK_OK(sensitivity_result_make(MOVERS, SOLUTIONS, s));
    for (int k = 0; k < MOVERS; k++) {
        mover *p = &s->mover[k];
        (void)snprintf(p->name, sizeof p->name, "radius <%d>", k);
        (void)snprintf(p->unit, sizeof p->unit, "mm");
        p->value = 3.6;
        p->drawn = true;
        for (int end = 0; end < MOVER_ENDS; end++) {
            p->end[end] = (mover_end){.asked = true, .value = 3.5 + 0.2 * end, .text = "end"};
        }
    }
    for (int i = 0; i < MOVERS * SOLUTIONS; i++) {
        s->move[i] =
            (move){.rate = {0.01 * i, 0, 0.02}, .moved = {{-1e-3 * i, 0, -2e-3}, {NAN, 0, 0}}};
    }
    s->solution[1] = 1;
    monte_carlo m = {0};
    CHECK_OK(monte_carlo_make(s, &m));
    m.nsample = 50;
    m.seed = 9;
    m.used[0] = 50;
    m.spread[3].mean = 0.25;
    m.share[5] = NAN;
    s->monte_carlo = m;
    r->has_sensitivity = true;
}

static void sizes_and_order(const run_result *r)
{
    int order[MOST_MOVERS];
    const move *m = sensitivity_move(&r->sensitivity, 1, 1);
    CHECK_NEAR(move_size(m, MOVER_LOW), sqrt(9e-6 + 4e-6), 1e-14);
    CHECK(isnan(move_size(m, MOVER_HIGH)));
    CHECK_NEAR(move_largest(m), sqrt(13e-6), 1e-14);
    CHECK_NEAR(move_linear(&r->sensitivity.mover[1], m, MOVER_LOW), 0.1 * hypot(0.03, 0.02), 1e-12);
    // (-3, -2) mm moved, (-3, -2) mm by the derivative
    CHECK(move_nonlinearity(&r->sensitivity.mover[1], m, MOVER_LOW, 0.12) < 1e-12);
    CHECK(isnan(move_nonlinearity(&r->sensitivity.mover[1], m, MOVER_LOW, 1e5)));
    sensitivity_sort(&r->sensitivity, 1, order);
    CHECK(order[0] == 1 && order[1] == 0);
}

int main(void)
{
    run_result r = {0}, back = {0};
    char dir[64], path[80];
    size_t length = 0;
    scratch_make(dir);
    CHECK_OK(synthetic_make(SOLUTIONS, 1, -0.5, &r));
    fill(&r);
    sizes_and_order(&r);
    (void)snprintf(path, sizeof path, "%s/result.hdf", dir);
    CHECK_OK(result_store_write(&r, path));
    CHECK_OK(result_store_read(path, &back));
    CHECK(back.has_sensitivity && back.sensitivity.nmover == MOVERS);
    sizes_and_order(&back);
    CHECK(back.sensitivity.monte_carlo.seed == 9 && back.sensitivity.monte_carlo.used[0] == 50);
    CHECK(back.sensitivity.monte_carlo.spread[3].mean == 0.25);
    CHECK(isnan(back.sensitivity.monte_carlo.share[5]));
    CHECK(strcmp(back.sensitivity.mover[1].name, "radius <1>") == 0);
    CHECK_OK(report_page(&back, dir));
    char *page = whole_file(dir, "report.html", &length);
    CHECK(page && well_formed(page) && strstr(page, "radius &lt;1&gt;"));
    free(page);
    run_result_free(&back);
    // about a solution that the rod has not
    r.sensitivity.solution[1] = 7;
    (void)unlink(path);
    CHECK_OK(result_store_write(&r, path));
    CHECK(result_store_read(path, &back) == ERR_FILE);
    status_clear();
    scratch_free(dir);
    sensitivity_result_free(&r.sensitivity);
    synthetic_free(&r);
    return test_failures != 0;
}
