// measure/line_file.c
#include "measure/line_file.h"

#include "base/memory.h"
#include "measure/table.h"

#include <math.h>

// a rod does not stretch to this many times its length, nor is so little of it worth a comparison
#define MOST_LENGTHS 2.0
#define LEAST_LENGTHS 0.01
// chords are no longer than their arcs, but for a scanner's noise; a rod that winds up stays larger
// than this share of its length
#define MOST_CHORD 1.5
#define LEAST_CHORD 0.005
#define MOST_CORRELATION 1e3 // [m], as the case's own key has it

static const char *const sigma_names = "sigma|standard_deviation|uncertainty";
static const char *const own_sigma_names = "fit_sigma"; // a scan's, without that of its frame

static status take(const table *t, const char *name, double **out)
{
    status st = OK;
    int column = 0;
    double *a = NULL;
    TRY(table_need(t, name, DIM_LENGTH, &column));
    TRY(table_take(t, column, DIM_LENGTH, &a));
    for (int i = 0; i < t->nrow; i++) {
        if (isnan(a[i])) {
            TRY(table_fail(t, i, "a measured line has no gaps, and '%s' is missing here", name));
        }
    }
    *out = a;
    a = NULL;

done:
    free(a);
    return st;
}

static status take_places(const table *t, centreline *c)
{
    static const char *const axis[3] = {"x", "y", "z"};
    status st = OK;
    double *a = NULL;
    for (int d = 0; d < 3; d++) {
        TRY(take(t, axis[d], &a));
        for (int i = 0; i < c->count; i++) {
            c->p[i].a[d] = a[i];
        }
        free(a);
        a = NULL;
    }

done:
    free(a);
    return st;
}

static status take_sigma(const table *t, const char *names, int count, double *sigma)
{
    status st = OK;
    double *a = NULL;
    int column = table_find(t, names);
    for (int i = 0; i < count; i++) {
        sigma[i] = NAN;
    }
    if (column >= 0) {
        TRY(table_need(t, names, DIM_LENGTH, &column));
        TRY(table_take(t, column, DIM_LENGTH, &a));
        for (int i = 0; i < count; i++) {
            sigma[i] = a[i];
            if (a[i] < 0) {
                TRY(table_fail(t, i, "the standard deviation %g mm is negative", 1e3 * a[i]));
            }
        }
    }

done:
    free(a);
    return st;
}

static status check_arclength(const table *t, const centreline *c, double length)
{
    const double end = c->s[c->count - 1];
    if (c->s[0] < 0) {
        return table_fail(t, 0, "s = %g mm lies before the base", 1e3 * c->s[0]);
    }
    for (int i = 1; i < c->count; i++) {
        if (!(c->s[i] > c->s[i - 1])) {
            return table_fail(t, i, "s does not ascend: %g mm after %g mm", 1e3 * c->s[i],
                              1e3 * c->s[i - 1]);
        }
    }
    if (end > MOST_LENGTHS * length || end < LEAST_LENGTHS * length) {
        return table_fail(t, c->count - 1, "s ends at %g mm on a rod of %g mm: is its unit right?",
                          1e3 * end, 1e3 * length);
    }
    return OK;
}

static status check_places(const table *t, const centreline *c)
{
    const double span = c->s[c->count - 1] - c->s[0];
    double most = 0;
    for (int i = 1; i < c->count; i++) {
        most = fmax(most, vec3_norm(vec3_sub(c->p[i], c->p[0])));
    }
    if (most > MOST_CHORD * span || most < LEAST_CHORD * span) {
        return table_fail(t, -1,
                          "over %g mm of s the places are up to %g mm from the first: do s, x, y "
                          "and z have their right units?",
                          1e3 * span, 1e3 * most);
    }
    return OK;
}

static status take_notes(const table *t, centreline *c)
{
    status st = OK;
    double length = 0;
    long line = 0;
    c->turn_free = table_says(t, LINE_TURN_FREE);
    TRY(table_note(t, "correlation_length", DIM_LENGTH, &length, &line));
    if (line > 0 && !(length > 0 && length < MOST_CORRELATION)) {
        TRY(table_fail(t, -1, "the correlation length %g mm is none", 1e3 * length));
    }
    c->correlation_length = line > 0 ? length : NAN;

done:
    return st;
}

status line_file_read(const char *directory, const key_text *name, double length, centreline *out,
                      bool *synthetic)
{
    static const table_limits limits = {.bytes = 16 << 20, .rows = 20000};
    status st = OK;
    table t = {0};
    centreline c = {0};
    double *s = NULL;
    TRY(table_read(directory, name, &limits, &t));
    if (t.nrow < 2) {
        TRY(table_fail(&t, -1, "%d row%s: a measured line takes two or more", t.nrow,
                       t.nrow == 1 ? "" : "s"));
    }
    TRY(take(&t, "s", &s));
    TRY(centreline_make(t.nrow, &c));
    for (int i = 0; i < c.count; i++) {
        c.s[i] = s[i];
    }
    TRY(take_places(&t, &c));
    TRY(take_sigma(&t, sigma_names, c.count, c.sigma));
    TRY(take_sigma(&t, own_sigma_names, c.count, c.own));
    TRY(take_notes(&t, &c));
    TRY(check_arclength(&t, &c, length));
    TRY(check_places(&t, &c));
    *synthetic = *synthetic || table_says(&t, "synthetic");
    *out = c;
    c = (centreline){0};

done:
    free(s);
    centreline_free(&c);
    table_free(&t);
    return st;
}
