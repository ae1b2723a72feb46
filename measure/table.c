// measure/table.c
#include "measure/table_cells.h"

#include "base/memory.h"
#include "measure/table_units.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

void table_free(table *t)
{
    free(t->path);
    free(t->a);
    free(t->line);
    free(t->head);
    free(t->word);
    *t = (table){0};
}

static status fail_at(const table *t, long line, const char *format, va_list args)
{
    char words[512];
    const input_file file = {.path = t->path};
    (void)vsnprintf(words, sizeof words, format, args);
    return input_file_fail(&file, line, "%s", words);
}

status table_fail(const table *t, int row, const char *format, ...)
{
    va_list args;
    va_start(args, format);
    const status st = fail_at(t, row < 0 ? 0 : t->line[row], format, args);
    va_end(args);
    return st;
}

status table_fail_names(const table *t, const char *format, ...)
{
    va_list args;
    va_start(args, format);
    const status st = fail_at(t, t->name_line, format, args);
    va_end(args);
    return st;
}

int table_find_next(const table *t, const char *names, int from)
{
    for (int i = from; i < t->ncolumn; i++) {
        if (cell_one_of(t->column[i].name, names)) {
            return i;
        }
    }
    return -1;
}

int table_find(const table *t, const char *names)
{
    return table_find_next(t, names, 0);
}

static status find_unit(const table *t, int column, dimension d, table_unit *u)
{
    char words[128];
    const table_column *c = &t->column[column];
    table_unit_words(d, words, sizeof words);
    if (c->unit[0] == '\0' && d != DIM_NONE) {
        return table_fail_names(t, "column '%s' has no unit: write '%s [%.*s]', or another of %s",
                                c->name, c->name, (int)strcspn(words, ","), words, words);
    }
    if (!table_unit_find(c->unit, strlen(c->unit), u)) {
        return table_fail_names(t, "unknown unit '%s' of column '%s': known are %s", c->unit,
                                c->name, words);
    }
    if (u->d != d) {
        return table_fail_names(t, "column '%s' cannot be in '%s': it takes %s", c->name, c->unit,
                                words);
    }
    return OK;
}

status table_need(const table *t, const char *names, dimension d, int *column)
{
    char words[128];
    table_unit u;
    const int first = table_find(t, names), length = (int)strcspn(names, "|");
    table_unit_words(d, words, sizeof words);
    if (first < 0) {
        return table_fail_names(t, "no column '%.*s%s%.*s' in the line of names", length, names,
                                d == DIM_NONE ? "" : "_",
                                d == DIM_NONE ? 0 : (int)strcspn(words, ","), words);
    }
    const int second = table_find_next(t, names, first + 1);
    if (second >= 0) {
        return table_fail_names(t, "two columns '%s'", t->column[second].name);
    }
    *column = first;
    return find_unit(t, first, d, &u);
}

status table_column_si(const table *t, int column, dimension d, double *factor)
{
    status st = OK;
    table_unit u;
    TRY(find_unit(t, column, d, &u));
    *factor = u.factor;

done:
    return st;
}

status table_take(const table *t, int column, dimension d, double **out)
{
    status st = OK;
    table_unit u;
    double *a = NULL;
    TRY(find_unit(t, column, d, &u));
    TRY(TAKE(a, (size_t)t->nrow));
    for (int i = 0; i < t->nrow; i++) {
        a[i] = table_unit_si(u, t->a[(size_t)i * (size_t)t->ncolumn + (size_t)column]);
    }
    *out = a;

done:
    return st;
}
