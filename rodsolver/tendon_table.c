// rodsolver/tendon_table.c
#include "rodsolver/tendon_table.h"

#include <math.h>

// The slope of a spline of degree 7 has bounded sixth derivatives: as much as the quadrature of
// order 6 needs, so that no knot of it must be an edge.
enum { SMOOTH_ENOUGH = 7 };

// a table that ends within this part of its length of the tendon's ends reaches them
static const double same_end = 1e-6;
// points nearer to each other than this part of the length are at one place
static const double same_place = 1e-9;

static status fail(const tendon_spec *spec, const char *what, int row)
{
    return status_fail_at(ERR_INPUT, spec->at.line, spec->at.column,
                          "rod: tendon '%s': row %d of its table %s", spec->name ? spec->name : "?",
                          row + 1, what);
}

static status check(const tendon_spec *spec)
{
    const tendon_table *t = &spec->table;
    const double *p = t->point;
    if (t->count < 2 || !p) {
        return fail(spec, "is missing: a path needs two points", 1);
    }
    if (!(t->smooth >= 0 && isfinite(t->smooth))) {
        return status_fail_at(ERR_INPUT, spec->at.line, spec->at.column,
                              "rod: tendon '%s': its table cannot be smoothed by %g m",
                              spec->name ? spec->name : "?", t->smooth);
    }
    for (int i = 0; i < t->count; i++, p += 3) {
        if (!isfinite(p[0]) || !isfinite(p[1]) || !isfinite(p[2])) {
            return fail(spec, "is not finite", i);
        }
        if (i > 0 && !(p[0] - p[-3] > same_place * spec->end)) {
            return fail(spec, "does not lie beyond the one before", i);
        }
    }
    const double first = t->point[0], last = t->point[3 * (t->count - 1)];
    if (first > same_end * spec->end || last < spec->end * (1 - same_end)) {
        return status_fail_at(ERR_INPUT, spec->at.line, spec->at.column,
                              "rod: tendon '%s': its table runs from s = %.6g mm to %.6g mm, the "
                              "tendon from 0 to %.6g mm",
                              spec->name ? spec->name : "?", 1e3 * first, 1e3 * last,
                              1e3 * spec->end);
    }
    return OK;
}

// --- through the points

// in the middles between the points, how far the curve and another one lie apart at most; NULL: the
// straight lines
static double distance(const tendon_table *t, const spline *curve, const spline *other)
{
    double most = 0;
    for (int i = 0; i + 1 < t->count; i++) {
        const double *p = t->point + 3 * (size_t)i, s = (p[0] + p[3]) / 2;
        double at[2], to[2] = {(p[1] + p[4]) / 2, (p[2] + p[5]) / 2}, slope[2];
        spline_at(curve, s, at, slope);
        if (other) {
            spline_at(other, s, to, slope);
        }
        most = fmax(most, hypot(at[0] - to[0], at[1] - to[1]));
    }
    return most;
}

// High degrees follow a well sampled path best and swing where points are few for what they show.
static status pass_through(const tendon_table *t, spline *out)
{
    status st = OK;
    spline cubic = {0}, higher = {0};
    double rms;
    const int n = t->count, low = n > 3 ? 3 : n - 1;
    TRY(spline_fit(n, t->point, low, n - low, &rms, &cubic));
    const double bend = distance(t, &cubic, NULL);
    for (int degree = SMOOTH_ENOUGH; degree > low; degree -= 2) {
        if (n > degree && spline_fit(n, t->point, degree, n - degree, &rms, &higher) == OK) {
            if (distance(t, &higher, &cubic) < bend) {
                *out = higher;
                higher = (spline){0};
                goto done;
            }
            spline_free(&higher);
        }
        status_clear();
    }
    *out = cubic;
    cubic = (spline){0};

done:
    spline_free(&cubic);
    spline_free(&higher);
    return st;
}

// --- near the points

// about 1.4 times as many pieces
static int more_pieces(int npiece)
{
    const int power = npiece & -npiece; // of two: 2, 3, 4, 6, 8, 12, ...
    return npiece == 1 ? 2 : power == npiece ? npiece + npiece / 2 : npiece / 3 * 4;
}

static status pass_near(const tendon_table *t, spline *out)
{
    status st = OK;
    // the distances of n points that scatter by `smooth` have a mean of it give or take half of
    // this
    const double enough = t->smooth * (1 + 1 / sqrt(t->count));
    double rms = INFINITY;
    int degree = 0, npiece = 1;
    while (degree + npiece < t->count) {
        const status one = spline_fit(t->count, t->point, degree, npiece, &rms, out);
        if (one == ERR_NUMERIC) { // points too unevenly spaced for so many pieces
            status_clear();
            break;
        }
        TRY(one);
        if (rms <= enough) {
            goto done;
        }
        spline_free(out);
        if (degree < SMOOTH_ENOUGH) {
            degree++;
        } else {
            npiece = more_pieces(npiece);
        }
    }
    TRY(pass_through(t, out));

done:
    return st;
}

status tendon_table_fit(const tendon_spec *spec, spline *out)
{
    status st = OK;
    *out = (spline){0};
    if (spec->table.count == 0) {
        return OK;
    }
    TRY(check(spec));
    TRY(spec->table.smooth > 0 ? pass_near(&spec->table, out) : pass_through(&spec->table, out));

done:
    return st;
}

int tendon_table_kinks(const spline *path, int most, double *s)
{
    const int count = path->ncoef - path->degree - 1;
    if (path->ncoef == 0 || path->degree >= SMOOTH_ENOUGH || count > most) {
        return 0;
    }
    for (int i = 0; i < count; i++) {
        s[i] = path->knot[path->degree + 1 + i];
    }
    return count;
}
