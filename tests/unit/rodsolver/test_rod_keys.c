#include "rodsolver/rod_case.h"
#include "tests/test.h"

#include <string.h>

static const key *find(const key_table *table, const char *name)
{
    for (int i = 0; i < table->nkey; i++) {
        if (strcmp(table->keys[i].name, name) == 0) {
            return &table->keys[i];
        }
    }
    return NULL;
}

static void table_and_defaults_agree(void)
{
    const rod_case c = rod_case_default();
    const rod_case *initial = rod_keys.initial;
    CHECK(rod_keys.size == sizeof(rod_case));
    CHECK(c.frame == FRAME_GC && c.points == 121 && c.tolerance == 1e-9);
    CHECK(c.start == START_REST && !c.past && !c.derivatives);
    CHECK(initial->tolerance == atof(find(&rod_keys, "tolerance")->initial));
    CHECK(initial->points == atoi(find(&rod_keys, "points")->initial));
    CHECK(find(&rod_keys, "tendons")->table->size == sizeof(tendon_case));
    CHECK(find(&rod_keys, "loads")->table->size == sizeof(point_load));
    CHECK(find(&rod_keys, "line_loads")->table->size == sizeof(line_load));
    CHECK(find(&rod_keys, "length")->required);
    CHECK(strcmp(find(&rod_keys, "frame")->choices, "gc|nc") == 0);
}

// two tendons, one load at a place, one along the rod, and gravity
typedef struct small_rod {
    tendon_case tendon[2];
    point_load load[1];
    line_load line[1];
    sweep_case sweep[2];
    double tension[4], pull[4], factor[6], path[9];
    rod_case c;
} small_rod;

static void make(small_rod *r)
{
    *r = (small_rod){
        .tendon = {{.spec = {.at = {7, 5}, .name = "a"}}, {.spec = {.at = {8, 5}, .name = "b"}}},
        .load = {{.at = {10, 5}, .name = "push", .s = INFINITY}},
        .line = {{.at = {11, 5}, .name = "wind"}},
        .tension = {0.1, 0, 0, 0.2},
        .pull = {NAN, NAN, NAN, NAN},
        .factor = {1, 2, 3, 4, 5, 6},
        .c = rod_case_default(),
    };
    r->c.at = (mark){5, 1};
    r->c.length = 0.12;
    r->c.tendons = (key_list){.at = {6, 3}, .count = 2, .items = r->tendon};
    r->c.loads = (key_list){.at = {9, 3}, .count = 1, .items = r->load};
    r->c.line_loads = (key_list){.at = {10, 3}, .count = 1, .items = r->line};
    r->c.gravity[2] = -9.81;
    r->c.tensions = (key_rows){.at = {12, 3}, .nrow = 2, .ncol = 2, .a = r->tension};
}

static void add_pulls(small_rod *r)
{
    r->c.pulls = (key_rows){.at = {13, 3}, .nrow = 2, .ncol = 2, .a = r->pull};
}

static void add_sweep(small_rod *r)
{
    const sweep_case open = {
        .from = {NAN, NAN, NAN}, .to = {NAN, NAN, NAN}, .steps = 2, .at = {15, 5}};
    r->sweep[0] = r->sweep[1] = open;
    r->sweep[0].of[SWEEP_TENSION] = (key_text){"a", {15, 17}};
    r->sweep[0].from[SWEEP_TENSION] = 0.3;
    r->sweep[0].to[SWEEP_TENSION] = 0.5;
    r->sweep[1].of[SWEEP_LOAD] = (key_text){"gravity", {16, 17}};
    r->sweep[1].from[SWEEP_LOAD] = 0;
    r->sweep[1].to[SWEEP_LOAD] = 1;
    r->c.sweep = (key_list){.at = {14, 3}, .count = 2, .items = r->sweep};
}

static void fails_at(small_rod *r, int line, const char *words)
{
    mark where = {0};
    status_clear();
    const status st = rod_case_bind(&r->c, &where);
    (void)status_place(&where.line, &where.column);
    if (st != ERR_INPUT || where.line != line || !strstr(status_message(), words)) {
        test_failures++;
        printf("wanted '%s' in line %d, not: %d, line %d, '%s'\n", words, line, (int)st, where.line,
               status_message());
    }
    status_clear();
    rod_case_release(&r->c);
}

static void is_fine(small_rod *r)
{
    mark where;
    CHECK_OK(rod_case_bind(&r->c, &where));
}

static void tendons_are_held_against_the_rod(void)
{
    small_rod r;
    make(&r);
    r.tendon[1].spec.end = 0.13;
    fails_at(&r, 8, "beyond the rod's length");
    make(&r);
    r.tendon[1].spec.name = "a";
    fails_at(&r, 8, "two tendons are called 'a'");
    make(&r);
    r.tendon[0].spec.table.smooth = 1e-3;
    fails_at(&r, 7, "no `path_mm`");
    make(&r);
    r.tendon[0].spec.outside = 1;
    fails_at(&r, 7, "does not stretch");
    make(&r);
    r.tendon[1].path = (key_rows){.at = {8, 20}, .nrow = 3, .ncol = 3, .a = r.path};
    r.path[3] = 0.05;
    r.path[6] = 0.05;
    fails_at(&r, 8, "row 3 of the tendon's path does not lie beyond");
    make(&r);
    r.tendon[1].path = (key_rows){.at = {8, 20}, .nrow = 1, .ncol = 3, .a = r.path};
    fails_at(&r, 8, "takes two or more");
    make(&r);
    r.tendon[1].path = (key_rows){.at = {8, 20}, .nrow = 3, .ncol = 3, .a = r.path};
    r.path[3] = 0.05;
    r.path[6] = 0.12;
    is_fine(&r);
    CHECK(r.c.spec[1].table.count == 3 && r.c.spec[1].table.point == r.path);
    rod_case_release(&r.c);
}

static void loads_are_held_against_the_rod(void)
{
    small_rod r;
    make(&r);
    r.load[0].s = 0.121;
    fails_at(&r, 10, "beyond the rod's length");
    make(&r);
    r.line[0].to = 0.13;
    fails_at(&r, 11, "beyond the rod's length");
    make(&r);
    r.line[0].from = 0.05;
    r.line[0].to = 0.05;
    fails_at(&r, 11, "begins at 50 mm and ends at 50 mm");
    make(&r);
    r.c.breaks = (key_rows){.at = {20, 3}, .nrow = 1, .ncol = 1, .a = r.path};
    r.path[0] = 0.2;
    fails_at(&r, 20, "a break at 200 mm");
}

static void rows_are_held_against_tendons_and_loads(void)
{
    small_rod r;
    make(&r);
    r.c.tensions.ncol = 1;
    fails_at(&r, 12, "1 number for 2 tendons");
    make(&r);
    r.tension[3] = -0.1;
    fails_at(&r, 12, "cannot push");
    make(&r);
    r.tension[3] = NAN;
    fails_at(&r, 12, "row 2 gives neither");
    make(&r);
    r.c.tensions = (key_rows){0};
    fails_at(&r, 6, "tendons without tensions");
    make(&r);
    add_pulls(&r);
    r.pull[1] = 1e-3;
    fails_at(&r, 13, "row 1 gives tension and pulled length of tendon 2");
    make(&r);
    r.c.factors = (key_rows){.at = {18, 3}, .nrow = 2, .ncol = 2, .a = r.factor};
    fails_at(&r, 18, "2 numbers for 3");
    make(&r);
    r.c.factors = (key_rows){.at = {18, 3}, .nrow = 3, .ncol = 3, .a = r.factor};
    fails_at(&r, 12, "2 rows here and 3 elsewhere");
}

static void a_row_gives_tension_or_pull(void)
{
    small_rod r;
    double tension[2], pull[2], load[3];
    make(&r);
    add_pulls(&r);
    r.tension[1] = NAN;
    r.pull[1] = 2e-3;
    r.c.factors = (key_rows){.at = {18, 3}, .nrow = 1, .ncol = 3, .a = r.factor};
    is_fine(&r);
    CHECK(rod_case_solutions(&r.c) == 2 && rod_case_loads(&r.c) == 3);
    rod_case_solution(&r.c, 0, tension, pull, load);
    CHECK(tension[0] == 0.1 && tension[1] == 0 && isnan(pull[0]) && pull[1] == 2e-3);
    CHECK(load[0] == 1 && load[1] == 2 && load[2] == 3);
    rod_case_solution(&r.c, 1, tension, pull, load);
    CHECK(tension[0] == 0 && tension[1] == 0.2 && isnan(pull[0]) && isnan(pull[1]));
    CHECK(load[2] == 3); // one row for all
    CHECK(rod_case_rows(&r.c).line == 12);
    rod_case_release(&r.c);
}

static void sweeps_make_a_grid(void)
{
    small_rod r;
    double tension[2], pull[2], load[3];
    make(&r);
    add_sweep(&r);
    is_fine(&r);
    CHECK(rod_case_solutions(&r.c) == 2 * 3 * 3);
    rod_case_solution(&r.c, 0, tension, pull, load);
    CHECK(tension[0] == 0.3 && tension[1] == 0 && load[0] == 1 && load[2] == 0);
    rod_case_solution(&r.c, 1, tension, pull, load);
    CHECK(tension[0] == 0.3 && load[2] == 0.5); // the last sweep runs fastest
    rod_case_solution(&r.c, 8, tension, pull, load);
    CHECK(tension[0] == 0.5 && tension[1] == 0 && load[2] == 1);
    rod_case_solution(&r.c, 9 + 3, tension, pull, load);
    CHECK_NEAR(tension[0], 0.4, 1e-15);
    CHECK(tension[1] == 0.2 && load[2] == 0);
    rod_case_release(&r.c);
}

static void a_sweep_may_take_the_place_of_rows(void)
{
    small_rod r;
    double tension[2], pull[2], load[3];
    make(&r);
    add_sweep(&r);
    r.sweep[1].of[SWEEP_LOAD] = (key_text){0};
    r.sweep[1].from[SWEEP_LOAD] = r.sweep[1].to[SWEEP_LOAD] = NAN;
    r.sweep[1].of[SWEEP_PULL] = (key_text){"b", {16, 17}};
    r.sweep[1].from[SWEEP_PULL] = 0;
    r.sweep[1].to[SWEEP_PULL] = 1e-3;
    r.c.tensions = (key_rows){0};
    is_fine(&r);
    CHECK(rod_case_solutions(&r.c) == 9);
    rod_case_solution(&r.c, 2, tension, pull, load);
    CHECK(tension[0] == 0.3 && isnan(pull[0]) && tension[1] == 0 && pull[1] == 1e-3);
    rod_case_release(&r.c);
}

static void mistakes_in_sweeps(void)
{
    small_rod r;
    make(&r);
    add_sweep(&r);
    r.sweep[0].of[SWEEP_TENSION].text = "c";
    fails_at(&r, 15, "no tendon is called 'c'");
    make(&r);
    add_sweep(&r);
    r.sweep[1].of[SWEEP_LOAD].text = "pish";
    fails_at(&r, 16, "no load is called 'pish' (did you mean 'push'?)");
    make(&r);
    add_sweep(&r);
    r.sweep[0].to[SWEEP_TENSION] = NAN;
    fails_at(&r, 15, "between `from_N` and `to_N`");
    make(&r);
    add_sweep(&r);
    r.sweep[0].from[SWEEP_LOAD] = 0;
    fails_at(&r, 15, "between `from_N` and `to_N`");
    make(&r);
    add_sweep(&r);
    r.sweep[1] = r.sweep[0];
    fails_at(&r, 15, "two sweeps of the same thing");
    make(&r);
    add_sweep(&r);
    r.sweep[0].steps = r.sweep[1].steps = ROD_CASE_SOLUTIONS - 1;
    fails_at(&r, 14, "too many solutions");
}

static void what_bends_without_tendons_is_one_solution(void)
{
    small_rod r;
    make(&r);
    r.c.tendons = (key_list){0};
    r.c.tensions = (key_rows){0};
    is_fine(&r);
    CHECK(rod_case_solutions(&r.c) == 1);
    rod_case_release(&r.c);
    r.c.loads = r.c.line_loads = (key_list){0};
    r.c.gravity[2] = 0;
    is_fine(&r);
    CHECK(rod_case_solutions(&r.c) == 0);
    rod_case_release(&r.c);
}

static void the_base_is_turned_then_pushed(void)
{
    const double right = acos(0.0);
    rod_case c = rod_case_default();
    c.base = (base_case){.position = {1, 2, 3}, .rotation = {0, right, 0}, .insertion = 0.5};
    c.base.turn = right;
    const pose g = rod_case_base(&c);
    CHECK_NEAR(g.p.a[0], 1.5, 1e-15); // its axis looks along x
    CHECK(g.p.a[1] == 2);
    CHECK_NEAR(g.p.a[2], 3, 1e-15);
    CHECK_NEAR(g.R.a[0][2], 1, 1e-15);
    CHECK_NEAR(g.R.a[1][0], 1, 1e-15); // its x was turned to y, about its own axis
}

int main(void)
{
    table_and_defaults_agree();
    tendons_are_held_against_the_rod();
    loads_are_held_against_the_rod();
    rows_are_held_against_tendons_and_loads();
    a_row_gives_tension_or_pull();
    sweeps_make_a_grid();
    a_sweep_may_take_the_place_of_rows();
    mistakes_in_sweeps();
    what_bends_without_tendons_is_one_solution();
    the_base_is_turned_then_pushed();
    return test_failures != 0;
}
