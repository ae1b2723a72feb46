// rodsolver/rod_case_bind.c
// What no single key of a rod shows: names, rows and places against one another.
#include "base/memory.h"
#include "base/nearest.h"
#include "rodsolver/rod_case.h"

#include <math.h>
#include <string.h>

// what the rounding of a unit may add to a place at the tip, over the length
static const double at_tip = 1e-12;

static bool beyond(const rod_case *c, double s)
{
    return s > c->length * (1 + at_tip);
}

static const char *or_nothing(const char *name)
{
    return name ? name : "";
}

// --- tendons

static status table_fails(const tendon_case *t, int row, const char *words)
{
    const mark at = mark_given(t->path.at) ? t->path.at : t->path_csv.at;
    return status_fail_at(ERR_INPUT, at.line, at.column, "row %d of the tendon's path %s", row + 1,
                          words);
}

static status check_table(const tendon_case *t)
{
    const tendon_table *table = &t->spec.table;
    if (table->count < 2) {
        const mark at = mark_given(t->path.at) ? t->path.at : t->path_csv.at;
        return status_fail_at(ERR_INPUT, at.line, at.column,
                              "a tendon's path takes two or more rows of s, x, y, this one has %d",
                              table->count);
    }
    for (int i = 0; i < table->count; i++) {
        const double *row = table->point + 3 * (size_t)i;
        if (!isfinite(row[0]) || !isfinite(row[1]) || !isfinite(row[2])) {
            return table_fails(t, i, "holds what is not a finite number");
        }
        if (i > 0 && !(row[0] > row[-3])) {
            return table_fails(t, i, "does not lie beyond the one before: s must ascend");
        }
    }
    return OK;
}

static status bind_tendon(const rod_case *c, tendon_case *t, tendon_spec *out, mark *where)
{
    status st = OK;
    tendon_table *table = &t->spec.table;
    const bool tabled = mark_given(t->path.at) || t->path_csv.text;
    *where = t->spec.at;
    if (beyond(c, t->spec.end)) {
        return status_fail(ERR_INPUT, "the tendon ends at %g mm, beyond the rod's length of %g mm",
                           1e3 * t->spec.end, 1e3 * c->length);
    }
    if (table->smooth > 0 && !tabled) {
        return status_fail(ERR_INPUT, "the tendon has no `path_mm` or `path_csv` to be smoothed");
    }
    if (t->spec.outside > 0 && t->spec.EA == 0) {
        return status_fail(ERR_INPUT, "a tendon without `EA_N` does not stretch, outside neither");
    }
    if (tabled) {
        table->count = t->read ? t->nread : t->path.nrow;
        table->point = t->read ? t->read : t->path.a;
        TRY(check_table(t));
    }
    *out = t->spec;

done:
    return st;
}

static status bind_tendons(rod_case *c, mark *where)
{
    status st = OK;
    tendon_case *t = c->tendons.items;
    TRY(TAKE(c->spec, (size_t)c->tendons.count));
    for (int i = 0; i < c->tendons.count; i++) {
        TRY(bind_tendon(c, &t[i], &c->spec[i], where));
        for (int j = 0; j < i && t[i].spec.name; j++) {
            if (t[j].spec.name && strcmp(t[i].spec.name, t[j].spec.name) == 0) {
                return status_fail(ERR_INPUT, "two tendons are called '%.60s'", t[i].spec.name);
            }
        }
    }

done:
    return st;
}

// --- loads and breaks

static status check_loads(const rod_case *c, mark *where)
{
    const point_load *load = c->loads.items;
    const line_load *line = c->line_loads.items;
    for (int i = 0; i < c->loads.count; i++) {
        *where = load[i].at;
        if (isfinite(load[i].s) && beyond(c, load[i].s)) {
            return status_fail(ERR_INPUT,
                               "the load lies at %g mm, beyond the rod's length of %g mm",
                               1e3 * load[i].s, 1e3 * c->length);
        }
    }
    for (int i = 0; i < c->line_loads.count; i++) {
        const double to = line[i].to > 0 ? line[i].to : c->length;
        *where = line[i].at;
        if (beyond(c, to)) {
            return status_fail(ERR_INPUT,
                               "the load ends at %g mm, beyond the rod's length of %g mm", 1e3 * to,
                               1e3 * c->length);
        }
        if (!(to > line[i].from)) {
            return status_fail(ERR_INPUT, "the load begins at %g mm and ends at %g mm",
                               1e3 * line[i].from, 1e3 * to);
        }
    }
    return OK;
}

static status check_breaks(const rod_case *c, mark *where)
{
    *where = c->breaks.at;
    for (int i = 0; i < c->breaks.nrow * c->breaks.ncol; i++) {
        if (beyond(c, c->breaks.a[i])) {
            return status_fail(ERR_INPUT, "a break at %g mm, beyond the rod's length of %g mm",
                               1e3 * c->breaks.a[i], 1e3 * c->length);
        }
    }
    return OK;
}

// --- sweeps

// the tendon or load that the sweep names; its number from 0
static status find_target(const rod_case *c, sweep_case *w)
{
    const key_text *of = &w->of[w->kind];
    const bool load = w->kind == SWEEP_LOAD;
    const int n = load ? rod_case_loads(c) : c->tendons.count;
    const point_load *point = c->loads.items;
    const line_load *line = c->line_loads.items;
    nearest near = nearest_to(of->text);
    for (int i = 0; i < n; i++) {
        const int k = i - c->loads.count;
        const char *name = !load                     ? c->spec[i].name
                           : k < 0                   ? point[i].name
                           : k < c->line_loads.count ? line[k].name
                                                     : "gravity";
        if (strcmp(or_nothing(name), of->text) == 0) {
            w->index = i;
            return OK;
        }
        if (name) {
            nearest_offer(&near, name, name);
        }
    }
    char words[NEAREST_WORDS];
    return status_fail_at(ERR_INPUT, of->at.line, of->at.column, "no %s is called '%.60s'%s",
                          load ? "load" : "tendon", of->text, nearest_words(&near, words));
}

static status bind_sweep(const rod_case *c, sweep_case *w, mark *where)
{
    static const char *const ends[SWEEP_KINDS] = {"`from_N` and `to_N`", "`from_mm` and `to_mm`",
                                                  "`from` and `to`"};
    *where = w->at;
    for (int k = 0; k < SWEEP_KINDS; k++) {
        w->kind = w->of[k].text ? k : w->kind;
    }
    for (int k = 0; k < SWEEP_KINDS; k++) {
        const bool both = !isnan(w->from[k]) && !isnan(w->to[k]);
        const bool none = isnan(w->from[k]) && isnan(w->to[k]);
        if (k == w->kind ? !both : !none) {
            return status_fail(ERR_INPUT, "this sweep goes between %s: give both, and no others",
                               ends[w->kind]);
        }
    }
    return find_target(c, w);
}

static status bind_sweeps(rod_case *c, mark *where)
{
    status st = OK;
    sweep_case *w = c->sweep.items;
    for (int i = 0; i < c->sweep.count; i++) {
        TRY(bind_sweep(c, &w[i], where));
        for (int j = 0; j < i; j++) {
            const bool load = w[i].kind == SWEEP_LOAD;
            if (w[j].index == w[i].index && load == (w[j].kind == SWEEP_LOAD)) {
                return status_fail(ERR_INPUT, "two sweeps of the same thing");
            }
        }
    }

done:
    return st;
}

// --- rows

static status check_columns(const key_rows *rows, int wanted, const char *what, const char *each,
                            mark *where)
{
    *where = rows->at;
    return rows->nrow == 0 || rows->ncol == wanted
               ? OK
               : status_fail(ERR_INPUT, "a row of %s has %d number%s for %d %s%s", what, rows->ncol,
                             rows->ncol == 1 ? "" : "s", wanted, each, wanted == 1 ? "" : "s");
}

static status check_counts(const rod_case *c, mark *where)
{
    const key_rows *all[3] = {&c->tensions, &c->pulls, &c->factors};
    int n = 0;
    for (int i = 0; i < 3; i++) {
        n = all[i]->nrow > n ? all[i]->nrow : n;
    }
    for (int i = 0; i < 3; i++) {
        if (all[i]->nrow > 1 && all[i]->nrow < n) {
            *where = all[i]->at;
            return status_fail(ERR_INPUT, "%d rows here and %d elsewhere: as many, or one for all",
                               all[i]->nrow, n);
        }
    }
    return OK;
}

static status check_amount(const rod_case *c, mark *where)
{
    const int n = rod_case_solutions(c);
    *where = c->sweep.count > 0 ? c->sweep.at : c->at;
    if (n > ROD_CASE_SOLUTIONS || (long)n * c->points > ROD_CASE_POINTS) {
        return status_fail(ERR_INPUT,
                           "too many solutions: at most %d, and %d points in all; see `points`",
                           ROD_CASE_SOLUTIONS, ROD_CASE_POINTS);
    }
    return OK;
}

// whether a sweep gives this tendon's tension or pulled length
static bool is_swept(const rod_case *c, int tendon)
{
    const sweep_case *w = c->sweep.items;
    for (int i = 0; i < c->sweep.count; i++) {
        if (w[i].kind != SWEEP_LOAD && w[i].index == tendon) {
            return true;
        }
    }
    return false;
}

static bool given(const key_rows *rows, int row, int j)
{
    const int i = rows->nrow == 1 ? 0 : row;
    return rows->nrow > 0 && !isnan(rows->a[(size_t)i * (size_t)rows->ncol + (size_t)j]);
}

// of every tendon either the tension or the pulled length, in every row
static status check_either(const rod_case *c, mark *where)
{
    const int nrow = c->tensions.nrow > c->pulls.nrow ? c->tensions.nrow : c->pulls.nrow;
    for (int i = 0; i < nrow; i++) {
        for (int j = 0; j < c->tendons.count; j++) {
            const bool tension = given(&c->tensions, i, j), pull = given(&c->pulls, i, j);
            *where = c->pulls.nrow > 0 ? c->pulls.at : c->tensions.at;
            if (tension && pull) {
                return status_fail(ERR_INPUT,
                                   "row %d gives tension and pulled length of tendon %d: write ~ "
                                   "for one of them",
                                   i + 1, j + 1);
            }
            if (!tension && !pull && !is_swept(c, j)) {
                return status_fail(ERR_INPUT,
                                   "row %d gives neither tension nor pulled length of tendon %d",
                                   i + 1, j + 1);
            }
        }
    }
    return OK;
}

static status check_push(const rod_case *c, mark *where)
{
    *where = c->tensions.at;
    for (int i = 0; i < c->tensions.nrow * c->tensions.ncol; i++) {
        if (c->tensions.a[i] < 0) {
            return status_fail(ERR_INPUT, "tension %g N: tendons cannot push", c->tensions.a[i]);
        }
    }
    return OK;
}

static status check_rows(const rod_case *c, mark *where)
{
    status st = OK;
    TRY(check_columns(&c->tensions, c->tendons.count, "tensions", "tendon", where));
    TRY(check_columns(&c->pulls, c->tendons.count, "pulled lengths", "tendon", where));
    TRY(check_columns(&c->factors, rod_case_loads(c), "load factors", "load", where));
    TRY(check_counts(c, where));
    TRY(check_push(c, where));
    TRY(check_either(c, where));
    for (int j = 0; j < c->tendons.count && c->tensions.nrow + c->pulls.nrow == 0; j++) {
        if (!is_swept(c, j) && !(c->unpulled && c->sweep.count == 0)) {
            *where = c->tendons.at;
            return status_fail(ERR_INPUT,
                               "tendons without tensions: add `tensions_N: [[...], ...]`, or "
                               "`pulls_mm`");
        }
    }
    TRY(check_amount(c, where));

done:
    return st;
}

status rod_case_bind(rod_case *c, mark *where)
{
    status st = OK;
    *where = c->at;
    TRY(bind_tendons(c, where));
    TRY(check_loads(c, where));
    TRY(check_breaks(c, where));
    TRY(bind_sweeps(c, where));
    TRY(check_rows(c, where));

done:
    return st;
}
