// fem/after_line.c
#include "fem/after_line.h"

#include "base/element.h"
#include "base/memory.h"

#include <math.h>

// points of a local polynomial where there are no layers
enum { NEAREST = 5, MOST = 2 * ELEMENT_MAX_ORDER };

// value[i]: the polynomials through n points that are 1 at one and 0 at the others, at t; slope may
// be NULL
static void lagrange(int n, const double *x, double t, double *value, double *slope)
{
    for (int i = 0; i < n; i++) {
        double scale = 1, v = 1, d = 0;
        for (int k = 0; k < n; k++) {
            if (k != i) {
                scale *= x[i] - x[k];
                d = d * (t - x[k]) + v;
                v *= t - x[k];
            }
        }
        value[i] = v / scale;
        if (slope) {
            slope[i] = d / scale;
        }
    }
}

// the first of `count` consecutive ones of n ascending points that lie around t
static int first_near(int n, const double *x, int count, double t)
{
    int above = 0, top = n; // the first point beyond t
    while (above < top) {
        const int mid = (above + top) / 2;
        if (x[mid] <= t) {
            above = mid + 1;
        } else {
            top = mid;
        }
    }
    int first = above - (count + 1) / 2;
    // an odd count has one more on the side that is nearer
    if (count % 2 == 1 && above > 0 && above < n && x[above] - t < t - x[above - 1]) {
        first++;
    }
    first = first < n - count ? first : n - count;
    return first > 0 ? first : 0;
}

static void slopes_at_points(const after_line *line, const vec6 *f, vec6 *slope)
{
    const int count = line->n < NEAREST ? line->n : NEAREST;
    for (int i = 0; i < line->n; i++) {
        double value[NEAREST], d[NEAREST];
        const int first = first_near(line->n, line->z, count, line->z[i]);
        lagrange(count, line->z + first, line->z[i], value, d);
        slope[i] = (vec6){0};
        for (int k = 0; k < count; k++) {
            slope[i] = vec6_add(slope[i], vec6_scale(d[k], f[first + k]));
        }
    }
}

// the slope of each layer's polynomial at its Gauss points, [layers][order]
static void slopes_at_gauss(const after_line *line, const vec6 *f, double *z, vec6 *slope)
{
    const int p = line->order, nlayer = (line->n - 1) / p;
    double x[ELEMENT_MAX_ORDER], w[ELEMENT_MAX_ORDER], value[ELEMENT_MAX_ORDER + 1],
        d[ELEMENT_MAX_ORDER + 1];
    gauss_legendre(p, x, w);
    for (int layer = 0; layer < nlayer; layer++) {
        const double *at = line->z + layer * p;
        for (int g = 0; g < p; g++) {
            const int i = layer * p + g;
            z[i] = (at[0] + at[p]) / 2 + x[g] * (at[p] - at[0]) / 2;
            lagrange(p + 1, at, z[i], value, d);
            slope[i] = (vec6){0};
            for (int k = 0; k <= p; k++) {
                slope[i] = vec6_add(slope[i], vec6_scale(d[k], f[layer * p + k]));
            }
        }
    }
}

status line_slopes(const after_line *line, const vec6 *f, vec6 *slope)
{
    status st = OK;
    double *z = NULL;
    vec6 *at_gauss = NULL;
    const int n = line->n - 1, count = line->order + 2 < n ? line->order + 2 : n;
    if (line->order == 0) {
        slopes_at_points(line, f, slope);
        return OK;
    }
    TRY(TAKE(z, (size_t)n));
    TRY(TAKE(at_gauss, (size_t)n));
    slopes_at_gauss(line, f, z, at_gauss);
    for (int i = 0; i < line->n; i++) {
        double value[MOST];
        const int first = first_near(n, z, count, line->z[i]);
        lagrange(count, z + first, line->z[i], value, NULL);
        slope[i] = (vec6){0};
        for (int k = 0; k < count; k++) {
            slope[i] = vec6_add(slope[i], vec6_scale(value[k], at_gauss[first + k]));
        }
    }

done:
    free(z);
    free(at_gauss);
    return st;
}

// the points whose polynomial holds between points i and i + 1
static int piece(const after_line *line, int i, int *count)
{
    if (line->order > 0) {
        *count = line->order + 1;
        return i / line->order * line->order;
    }
    *count = line->n < NEAREST ? line->n : NEAREST;
    return first_near(line->n, line->z, *count, (line->z[i] + line->z[i + 1]) / 2);
}

vec6 line_mean_slope(const after_line *line, const vec6 *f, double centre, double half)
{
    vec6 slope = {0};
    double x[ELEMENT_MAX_ORDER + 1], w[ELEMENT_MAX_ORDER + 1];
    enum { RULE = ELEMENT_MAX_ORDER + 1 }; // exact for a quartic times z
    gauss_legendre(RULE, x, w);
    for (int i = 0; i + 1 < line->n; i++) {
        const double from = fmax(line->z[i], centre - half),
                     to = fmin(line->z[i + 1], centre + half);
        int count = 0;
        const int first = piece(line, i, &count);
        for (int g = 0; to > from && g < RULE; g++) {
            const double z = (from + to) / 2 + x[g] * (to - from) / 2;
            const double moment = w[g] * (to - from) / 2 * (z - centre) / (2 * pow(half, 3) / 3);
            double value[NEAREST];
            lagrange(count, line->z + first, z, value, NULL);
            for (int k = 0; k < count; k++) {
                slope = vec6_add(slope, vec6_scale(moment * value[k], f[first + k]));
            }
        }
    }
    return slope;
}
