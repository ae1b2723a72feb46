// base/field_table.c
#include "base/field_table.h"

#include <math.h>

static int entry_count(const key_rows *r)
{
    return r->nrow * r->ncol;
}

status field_table_check(const field_table *t)
{
    const int n = entry_count(&t->places);
    const mark at = t->places.at;
    if (n < 2) {
        return status_fail_at(ERR_INPUT, at.line, at.column,
                              "a table needs two places or more, found %d", n);
    }
    if (entry_count(&t->values) != n) {
        return status_fail_at(ERR_INPUT, t->values.at.line, t->values.at.column,
                              "a table of %d places needs as many values, found %d", n,
                              entry_count(&t->values));
    }
    for (int i = 1; i < n; i++) {
        if (!(t->places.a[i] > t->places.a[i - 1])) {
            return status_fail_at(ERR_INPUT, at.line, at.column,
                                  "the places of a table must ascend: entry %d is %g mm after "
                                  "%g mm",
                                  i + 1, 1e3 * t->places.a[i], 1e3 * t->places.a[i - 1]);
        }
    }
    return OK;
}

static double slope(const field_table *t, int i) // of the chord behind entry i
{
    return (t->values.a[i + 1] - t->values.a[i]) / (t->places.a[i + 1] - t->places.a[i]);
}

// at the end of a chord of slope d and length h, with the next of slope e and length g: the
// parabola's, but neither of the other sign nor so steep that the cubic overshoots
static double end_tangent(double d, double h, double e, double g)
{
    const double parabola = ((2 * h + g) * d - h * e) / (h + g);
    if (parabola * d <= 0) {
        return 0;
    }
    return d * e <= 0 && fabs(parabola) > 3 * fabs(d) ? 3 * d : parabola;
}

// the tangent at entry i: Fritsch and Butland's weighted harmonic mean of the chords on both sides
static double tangent(const field_table *t, int i)
{
    const int last = entry_count(&t->places) - 1;
    const double *x = t->places.a;
    if (last == 1) {
        return slope(t, 0);
    }
    if (i == 0) {
        return end_tangent(slope(t, 0), x[1] - x[0], slope(t, 1), x[2] - x[1]);
    }
    if (i == last) {
        return end_tangent(slope(t, last - 1), x[last] - x[last - 1], slope(t, last - 2),
                           x[last - 1] - x[last - 2]);
    }
    const double before = slope(t, i - 1), after = slope(t, i);
    const double h = x[i] - x[i - 1], g = x[i + 1] - x[i];
    return before * after <= 0 ? 0 : 3 * (h + g) / ((2 * g + h) / before + (g + 2 * h) / after);
}

static int interval_of(const field_table *t, double x) // entries i, i + 1 hold x
{
    int low = 0, high = entry_count(&t->places) - 1;
    while (high - low > 1) {
        const int middle = (low + high) / 2;
        if (t->places.a[middle] <= x) {
            low = middle;
        } else {
            high = middle;
        }
    }
    return low;
}

static double table_value(const field_table *t, double x)
{
    const int last = entry_count(&t->places) - 1;
    if (!(x > t->places.a[0])) {
        return t->values.a[0];
    }
    if (x >= t->places.a[last]) {
        return t->values.a[last];
    }
    const int i = interval_of(t, x);
    const double h = t->places.a[i + 1] - t->places.a[i], u = (x - t->places.a[i]) / h;
    const double a = t->values.a[i], b = t->values.a[i + 1];
    const double da = h * tangent(t, i), db = h * tangent(t, i + 1);
    return a + u * (da + u * (3 * (b - a) - 2 * da - db + u * (2 * (a - b) + da + db)));
}

static double table_at(const void *table, double x, double y, double s)
{
    const field_table *t = table;
    return table_value(t, t->along == TABLE_ALONG_X ? x : t->along == TABLE_ALONG_Y ? y : s);
}

place_field field_table_place(const field_table *t)
{
    return (place_field){.at = table_at,
                         .expression = t,
                         .across = t->along != TABLE_ALONG_S,
                         .along = t->along == TABLE_ALONG_S};
}
