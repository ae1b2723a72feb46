// measure/tensile_linear.c
// How far a curve follows the line of its modulus.
#include "measure/tensile_inside.h"

#include <math.h>

// neighbours: this share of the curve's strain, and how many of them
static const double reach = 0.02;
enum { FEWEST = 5, MOST = 400 };
// off the line in standard deviations of a mean, of which a curve has some hundred
static const double surely = 4;

typedef struct neighbours {
    int from;
    double off, line; // sums of the departure from the line, and of the line
} neighbours;

static void add(const tensile_curve *c, const tensile_choice *w, int i, int sign, neighbours *m)
{
    const double line = w->E * (c->strain[i] - w->zero);
    m->off += sign * (c->stress[i] - line);
    m->line += sign * line;
}

// Variance of one reading's share in a mean: the fit has seen means of several readings, tau of
// which go together
static double reading_variance(const tensile_curve *c, const tensile_choice *w)
{
    int inside = 0;
    for (int i = 0; i < c->n; i++) {
        inside += c->strain[i] >= w->stretch.from && c->strain[i] <= w->stretch.to;
    }
    const double each = fmax((double)inside / fmax(w->stretch.count, 1), 1);
    return w->fit.noise * w->fit.noise * w->fit.tau * each;
}

// how far the mean is further off than the share of the line
static double outside(const neighbours *m, int count, double departure)
{
    return (fabs(m->off) - departure * fabs(m->line)) / count;
}

void tensile_linear_range(const tensile_curve *c, const tensile_choice *w, double departure,
                          tensile_answer *a)
{
    const double white = reading_variance(c, w), most = w->fit.noise * w->fit.noise;
    const double apart = reach * (c->strain[c->n - 1] - c->strain[0]);
    neighbours m = {0, 0, 0};
    double end = NAN, at_before = NAN, over_before = 0, last = w->zero;
    while (m.from < c->n && c->strain[m.from] < w->zero) {
        m.from++;
    }
    a->linear_to_end = true;
    for (int i = m.from; i < c->n && a->linear_to_end; i++) {
        add(c, w, i, 1, &m);
        last = fmax(last, c->strain[i]);
        while (i - m.from >= FEWEST &&
               (c->strain[i] - c->strain[m.from] > apart || i - m.from > MOST)) {
            add(c, w, m.from++, -1, &m);
        }
        const int count = i - m.from + 1;
        if (count < FEWEST) {
            continue;
        }
        const double at = 0.5 * (c->strain[i] + c->strain[m.from]);
        const double over = outside(&m, count, departure);
        if (over <= 0 || isnan(end)) {
            end = at;
        } else if (over_before <= 0) { // it crosses between two means
            end = at_before + (at - at_before) * over_before / (over_before - over);
        }
        // the toe is off the line too
        a->linear_to_end = at < w->stretch.from || over <= surely * sqrt(fmin(white / count, most));
        at_before = at;
        over_before = over;
    }
    a->linear_strain = (a->linear_to_end ? last : end) - w->zero;
}
