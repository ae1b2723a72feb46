// app/tendon_path.c
#include "app/case_rod.h"

#include "base/memory.h"
#include "measure/table.h"

#include <math.h>

static const char *const names[3] = {"s", "x", "y"};

static status take_column(const table *t, int which, double *rows)
{
    status st = OK;
    int column = 0;
    double *values = NULL;
    TRY(table_need(t, names[which], DIM_LENGTH, &column));
    TRY(table_take(t, column, DIM_LENGTH, &values));
    for (int i = 0; i < t->nrow; i++) {
        if (isnan(values[i])) {
            TRY(table_fail(t, i, "a path has no gaps, and '%s' is missing here", names[which]));
        }
        rows[3 * (size_t)i + (size_t)which] = values[i];
    }

done:
    free(values);
    return st;
}

status tendon_path_read(const char *directory, const key_text *name, int *nrow, double **rows)
{
    static const table_limits limits = {.bytes = 16 << 20, .rows = 100000};
    status st = OK;
    table t = {0};
    double *a = NULL;
    TRY(table_read(directory, name, &limits, &t));
    if (t.nrow < 2) {
        TRY(table_fail(&t, -1, "%d rows: a path takes two or more", t.nrow));
    }
    TRY(TAKE(a, 3 * (size_t)t.nrow));
    for (int i = 0; i < 3; i++) {
        TRY(take_column(&t, i, a));
    }
    *nrow = t.nrow;
    *rows = a;
    a = NULL;

done:
    free(a);
    table_free(&t);
    return st;
}
