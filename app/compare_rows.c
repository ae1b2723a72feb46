// app/compare_rows.c
#include "app/compare_rows.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>

static const double section_most = 1e-2;

double compare_section_share(const compare_section *section)
{
    return fmin(COMPARE_MARGIN * section->error, section_most);
}

double compare_centre_distance(const double *a, const double *b)
{
    return hypot(a[0] - b[0], a[1] - b[1]);
}

compare_row *compare_add(run_result *r, const char *unit, const char *format, ...)
{
    va_list args;
    if (r->ncompare < COMPARE_MAX_ROWS) {
        r->ncompare++;
    }
    compare_row *row = &r->compare[r->ncompare - 1];
    *row = (compare_row){0};
    va_start(args, format);
    (void)vsnprintf(row->what, sizeof row->what, format, args);
    va_end(args);
    (void)snprintf(row->unit, sizeof row->unit, "%s", unit);
    return row;
}

void compare_judge(compare_row *row, double ours, double other, double difference, tolerance t)
{
    row->ours = ours;
    row->other = other;
    row->difference = difference;
    row->tolerance = t.value;
    row->ok = difference <= t.value;
    (void)snprintf(row->reason, sizeof row->reason, "%s", t.reason);
}

void compare_relative(compare_row *row, double ours, double other, tolerance t)
{
    compare_judge(row, ours, other, fabs(ours - other) / fabs(other), t);
}

void compare_skip(compare_row *row, const char *format, ...)
{
    va_list args;
    va_start(args, format);
    (void)vsnprintf(row->reason, sizeof row->reason, format, args);
    va_end(args);
    row->skipped = true;
    row->ok = true;
}
