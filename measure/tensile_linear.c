// measure/tensile_linear.c
// How far a curve follows the line of its modulus.
#include "measure/tensile_inside.h"

#include <math.h>

// neighbours: this share of the curve's strain, and how many of them
static const double reach = 0.02;
enum { FEWEST = 5, MOST = 400, BINS = 50 };
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

// where the means were last within the share of the line
typedef struct crossing {
    double end, at, over; // at, over: of the mean before
    bool left;            // surely beyond it since
} crossing;

static const crossing crossing_new = {.end = NAN, .at = NAN};

static void cross(crossing *x, double at, double over, bool surely_off)
{
    if (over <= 0 || isnan(x->end)) {
        x->end = at;
    } else if (x->over <= 0) { // it crosses between two means
        x->end = x->at + (at - x->at) * x->over / (x->over - over);
    }
    x->left = surely_off;
    x->at = at;
    x->over = over;
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
    crossing x = crossing_new;
    double last = w->zero;
    while (m.from < c->n && c->strain[m.from] < w->zero) {
        m.from++;
    }
    for (int i = m.from; i < c->n && !x.left; i++) {
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
        const bool surely_off = over > surely * sqrt(fmin(white / count, most));
        cross(&x, at, over, surely_off && at >= w->stretch.from); // the toe is off the line too
    }
    a->linear_to_end = !x.left;
    a->linear_strain = (x.left ? x.end : last) - w->zero;
}

// The weighted mean of several curves and that of their lines, which is the line of the pooled E:
// sums over curves of means over 2 % of the strain that all of them reach, from their zeros
typedef struct bins {
    double line[BINS], off[BINS], variance[BINS];
    double weight[BINS]; // of the curves that have readings there
} bins;

static status add_curve(const tensile_curve *c, const tensile_answer *a, double weight, double end,
                        bins *all)
{
    status st = OK;
    tensile_curve loading = {0};
    tensile_answer unused = {0};
    double off[BINS] = {0}, strain[BINS] = {0};
    int count[BINS] = {0};
    TRY(tensile_loading(c, &loading, &unused));
    for (int i = 0; i < loading.n; i++) {
        const double x = loading.strain[i] - a->strain_offset;
        const int k = (int)floor(BINS * fmin(fmax(x / end, -1), 2));
        if (k >= 0 && k < BINS) {
            off[k] += loading.stress[i] - a->E * x;
            strain[k] += x;
            count[k]++;
        }
    }
    // of the means that the fit has seen
    const double each = fmax(a->nwindow / (a->window[1] - a->window[0]) * end / BINS, 1);
    for (int k = 0; k < BINS; k++) {
        if (count[k] > 0) {
            all->off[k] += weight * off[k] / count[k];
            all->line[k] += weight * a->E * strain[k] / count[k];
            all->variance[k] +=
                weight * weight * a->noise * a->noise * fmin(a->correlation / each, 1);
            all->weight[k] += weight;
        }
    }

done:
    tensile_curve_free(&loading);
    return st;
}

status tensile_pool_linear(int n, const tensile_curve *const *c, const tensile_answer *a,
                           const bool *used, const tensile_rule *rule, tensile_pool *p)
{
    status st = OK;
    bins all = {{0}, {0}, {0}, {0}};
    crossing x = crossing_new;
    double end = INFINITY, toe = 0;
    if (p->n < 2) {
        return OK; // that of the curve
    }
    for (int i = 0; i < n; i++) {
        if (used[i]) {
            end = fmin(end, fmax(a[i].end - a[i].strain_offset, 0));
            toe = fmax(toe, a[i].window[0] - a[i].strain_offset);
        }
    }
    for (int i = 0; i < n; i++) {
        const double e = a[i].standard_error;
        if (used[i]) {
            TRY(add_curve(c[i], &a[i], 1 / (e * e + p->between * p->between), end, &all));
        }
    }
    for (int k = 0; k < BINS && !x.left; k++) {
        if (all.weight[k] > 0) {
            const double at = (k + 0.5) / BINS * end;
            const double over = fabs(all.off[k]) - rule->departure * fabs(all.line[k]);
            cross(&x, at, over, over > surely * sqrt(all.variance[k]) && at >= toe);
        }
    }
    p->linear_strain = x.left ? x.end : end;

done:
    return st;
}
