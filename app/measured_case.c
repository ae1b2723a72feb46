// app/measured_case.c
#include "app/measured_case.h"

#include "base/memory.h"

#include <math.h>
#include <stdio.h>

// as a person writes the same number twice
#define SAME_TENSION 1e-9

bool case_has_measured(const case_data *c)
{
    return mark_given(c->file.measured.at);
}

status case_need_measured(const case_data *c)
{
    return c->file.measured.shapes.count > 0
               ? OK
               : config_fail(c->config, (mark){1, 1}, "the case has no 'measured.shapes'");
}

typedef struct solution_room {
    double *tension, *pull, *load;
} solution_room;

static bool has_tensions(const rod_case *rod, int i, const double *wanted, const solution_room *a)
{
    rod_case_solution(rod, i, a->tension, a->pull, a->load);
    for (int k = 0; k < rod->tendons.count; k++) {
        const double most = fmax(fabs(wanted[k]), fabs(a->tension[k]));
        if (!isnan(a->pull[k]) || !(fabs(wanted[k] - a->tension[k]) <= SAME_TENSION * most)) {
            return false;
        }
    }
    return true;
}

static void tension_words(int n, const double *tension, char *text, size_t size)
{
    size_t used = 0;
    text[0] = '\0';
    for (int k = 0; k < n && used + 32 < size; k++) {
        used += (size_t)snprintf(text + used, size - used, "%s%g", k ? ", " : "", tension[k]);
    }
}

static status find_by_tensions(const case_data *c, measured_shape *shape, const solution_room *a)
{
    const rod_case *rod = &c->file.rod;
    const int nsolution = rod_case_solutions(rod);
    char words[200];
    int found = -1;
    if (shape->tensions.nrow != 1 || shape->tensions.ncol != rod->tendons.count) {
        return config_fail(c->config, shape->tensions.at,
                           "%d tension%s, but the rod has %d tendon%s", shape->tensions.ncol,
                           shape->tensions.ncol == 1 ? "" : "s", rod->tendons.count,
                           rod->tendons.count == 1 ? "" : "s");
    }
    tension_words(shape->tensions.ncol, shape->tensions.a, words, sizeof words);
    for (int i = 0; i < nsolution; i++) {
        if (has_tensions(rod, i, shape->tensions.a, a)) {
            if (found >= 0) {
                return config_fail(c->config, shape->tensions.at,
                                   "solutions %d and %d of the rod both have tensions of %s N: say "
                                   "which one by `solution`",
                                   found + 1, i + 1, words);
            }
            found = i;
        }
    }
    if (found < 0) {
        return config_fail(c->config, shape->tensions.at,
                           "the rod is not solved for tensions of %s N: add them to "
                           "rod.tensions_N, or give the `solution`",
                           words);
    }
    shape->index = found;
    return OK;
}

static status find_solution(const case_data *c, measured_shape *shape, const solution_room *a)
{
    const int nsolution = rod_case_solutions(&c->file.rod);
    if (shape->solution > nsolution) {
        return config_fail(c->config, shape->at, "solution %d, but the rod has %d", shape->solution,
                           nsolution);
    }
    shape->index = shape->solution - 1;
    return shape->solution > 0 ? OK : find_by_tensions(c, shape, a);
}

static status find_solutions(const case_data *c)
{
    status st = OK;
    const rod_case *rod = &c->file.rod;
    measured_shape *shape = c->file.measured.shapes.items;
    solution_room a = {0};
    TRY(TAKE(a.tension, (size_t)rod->tendons.count));
    TRY(TAKE(a.pull, (size_t)rod->tendons.count));
    TRY(TAKE(a.load, (size_t)rod_case_loads(rod)));
    for (int i = 0; i < c->file.measured.shapes.count; i++) {
        TRY(find_solution(c, &shape[i], &a));
    }

done:
    free(a.load);
    free(a.pull);
    free(a.tension);
    return st;
}

status case_measured_bind(case_data *c, const char *directory)
{
    status st = OK;
    measured_case *measured = &c->file.measured;
    mark where = measured->at;
    if (!case_has_rod(c)) {
        return config_fail(c->config, where, "measured shapes need a 'rod' to be held against");
    }
    if (measured->shapes.count == 0 && measured->paper == PAPER_NONE) {
        return config_fail(c->config, where, "neither shapes nor a table of the paper");
    }
    TRY(find_solutions(c));
    st = measured_case_read(measured, directory, c->file.rod.length, &where);
    TRY(case_place(c, st, where));

done:
    return st;
}
