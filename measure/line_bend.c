// measure/line_bend.c
// How a measured line bends, with its uncertainty.
#include "measure/line_fit.h"
#include "measure/shape_error.h"

enum { MOST_PLACES = 512 }; // of a window
#define ROUNDING 1e-9

// the stations within half a window of `at`; 0 where the window is not whole
static int window_of(const centreline *c, double at, double window, int *first)
{
    const double half = 0.5 * window * (1 + ROUNDING);
    int n = 0;
    if (at - half < c->s[0] - ROUNDING * window ||
        at + half > c->s[c->count - 1] + ROUNDING * window * 2) {
        return 0;
    }
    while (c->s[*first] < at - half) {
        (*first)++;
    }
    while (*first + n < c->count && n < MOST_PLACES && c->s[*first + n] <= at + half) {
        n++;
    }
    return n;
}

static double bend_sigma(const centreline *c, int first, int n, double at)
{
    double weight[MOST_PLACES];
    vec3 part[MOST_PLACES];
    line_fit_bend_weights(n, c->s + first, at, weight);
    for (int i = 0; i < n; i++) {
        part[i] = (vec3){{weight[i] * centreline_own_sigma(c, first + i), 0, 0}};
    }
    return sqrt(correlated_variance(n, c->s + first, part, c->correlation_length));
}

void centreline_bend(const centreline *c, double window, vec3 *bend, double *sigma)
{
    int first = 0;
    for (int i = 0; i < c->count; i++) {
        const int n = window_of(c, c->s[i], window, &first);
        bend[i] = (vec3){{NAN, NAN, NAN}};
        sigma[i] = NAN;
        if (n > 3) {
            const line_fit f = line_fit_at(n, c->s + first, c->p + first, c->s[i]);
            const double speed = vec3_norm(f.slope);
            bend[i] = vec3_scale(1 / (speed * speed), vec3_cross(f.slope, f.bend));
            sigma[i] = bend_sigma(c, first, n, c->s[i]) / speed;
        }
    }
}
