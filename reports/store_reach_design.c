// reports/store_reach_design.c
#include "reach/reach_case.h"
#include "reports/store_reach.h"

#include <limits.h>

static status pass_head(const passage *p, reach_design_result *d)
{
#define OF(member) offsetof(reach_design_result, member)
    static const column columns[] = {
        {"scope", COLUMN_TEXT, "-", OF(scope), 0, {REACH_NAME}, 0},
        {"goal", COLUMN_INT, "0 targets, 1 area", OF(goal), 0, {0}, DESIGN_AREA},
        {"start_goal", COLUMN_KNOWN, "-", OF(start_goal), 0, {0}, 0},
        {"start_score", COLUMN_KNOWN, "-", OF(start_score), 0, {0}, 0},
        {"evaluations", COLUMN_INT, "-", OF(evaluations), 0, {0}, INT_MAX},
        {"failed", COLUMN_INT, "-", OF(failed), 0, {0}, INT_MAX},
        {"islands", COLUMN_INT, "-", OF(islands), 0, {0}, INT_MAX},
        {"seed", COLUMN_INT, "-", OF(seed), 0, {0}, INT_MAX},
    };
#undef OF
    return passage_columns(p, "reach/design", COUNT_OF(columns), columns, single(d));
}

static status pass_parameters(const passage *p, reach_design_result *d)
{
    static const column lower = {"lower", COLUMN_REAL, "see unit", 0, 0, {0}, 0};
    static const column upper = {"upper", COLUMN_REAL, "see unit", 0, 0, {0}, 0};
    static const column start = {"start", COLUMN_REAL, "see unit", 0, 0, {0}, 0};
    static const char *const group = "reach/design/parameter";
    status st = OK;
    const int n = d->nparameter;
    TRY(store_pass_lines(p, group, "name", n, d->name, sizeof *d->name));
    TRY(store_pass_lines(p, group, "unit", n, d->unit, sizeof *d->unit));
    TRY(passage_columns(p, group, 1, &lower, rows_of(d->lower, n, sizeof *d->lower)));
    TRY(passage_columns(p, group, 1, &upper, rows_of(d->upper, n, sizeof *d->upper)));
    TRY(passage_columns(p, group, 1, &start, rows_of(d->start, n, sizeof *d->start)));

done:
    return st;
}

static status pass_rows(const passage *p, reach_design_result *d)
{
#define OF(member) offsetof(reach_design_row, member)
    static const column columns[] = {
        {"goal", COLUMN_KNOWN, "-", OF(goal), 0, {0}, 0},
        {"score", COLUMN_KNOWN, "-", OF(score), 0, {0}, 0},
        {"island", COLUMN_INT, "-", OF(island), 0, {0}, INT_MAX},
        {"evaluation", COLUMN_INT, "-", OF(evaluation), 0, {0}, INT_MAX},
    };
    const column value = {"value", COLUMN_REAL, "see unit", OF(value), 1, {(size_t)d->nparameter},
                          0};
#undef OF
    static const char *const group = "reach/design/row";
    status st = OK;
    column_rows rows = rows_of(d->row, d->nrow, sizeof *d->row);
    TRY(passage_columns(p, group, COUNT_OF(columns), columns, rows));
    rows.behind = true;
    TRY(passage_columns(p, group, 1, &value, rows));

done:
    return st;
}

status store_pass_reach_design(const passage *p, reach_design_result *d)
{
    status st = OK;
    int n = d->nparameter, k = d->nrow, best = d->best;
    if (p->reading ? !store_has(p->store, "reach/design/row_count") : !d->there) {
        return OK;
    }
    TRY(passage_count(p, "reach/design/parameter_count", 1, DESIGN_PARAMETERS, &n));
    TRY(passage_count(p, "reach/design/row_count", 0, MOST_ROWS, &k));
    TRY(p->reading ? reach_design_make(n, k, d) : OK);
    TRY(passage_count(p, "reach/design/best", 0, k > 0 ? k - 1 : 0, &best));
    d->best = best;
    TRY(pass_head(p, d));
    TRY(pass_parameters(p, d));
    TRY(pass_rows(p, d));

done:
    return st;
}
