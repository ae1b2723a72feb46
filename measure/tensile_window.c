// measure/tensile_window.c
// Which stretch of a loading is straight, and gives the modulus most closely.
#include "measure/tensile_inside.h"

#include "base/memory.h"

#include <math.h>
#include <string.h>

// Limits of the rule. A bend passes for none below so many of its standard errors; what could just
// not be seen is kept away from by shortening the stretch, and by leaving more than the toe.
static const double straight_limit = 2.5, surely_straight = 1;
static const double shorten = 0.7, longer_toe = 1.5, least_start = 0.15;
static const double furthest = 1.5, sure = 3, well_known = 0.05, toe_rise = 0.1;
// A tenth of a permille of the stress is straight, however little the noise; where a curve has so
// little that nothing else is straight, more is, up to a per cent
static const double least_bend = 1e-4, most_bend = 1.1e-2, more_bend = 10;
static const double toe_step = 1.6, toe_least = 0.002, toe_most = 0.6, end_step = 0.87;

enum { FEWEST = 8, PIECES = 4, PIECE_FEWEST = 12, TOE_LENGTHS = 4 };

static int first_at(const tensile_curve *c, double strain)
{
    int i = 0;
    while (i < c->n && c->strain[i] < strain) {
        i++;
    }
    return i;
}

static int last_at(const tensile_curve *c, double strain)
{
    int i = c->n;
    while (i > 0 && c->strain[i - 1] > strain) {
        i--;
    }
    return i;
}

static tensile_stretch stretch_between(const tensile_curve *c, double from, double to)
{
    const int first = first_at(c, from);
    return (tensile_stretch){first, last_at(c, to) - first, from, to};
}

// the noise's correlation from short pieces, in which no curve bends: the median of them
static status local_correlation(const gsl_line_door *door, const tensile_curve *c, double *tau)
{
    status st = OK;
    double all[PIECES];
    int n = 0;
    const int fit = c->n / PIECE_FEWEST, pieces = fit < 1 ? 1 : fit < PIECES ? fit : PIECES;
    for (int i = 0; i < pieces; i++) {
        tensile_fit f;
        const int first = (int)((long)c->n * i / pieces),
                  end = (int)((long)c->n * (i + 1) / pieces);
        const double from = c->strain[first], to = c->strain[end - 1];
        if (to > from && end - first >= FEWEST) {
            TRY(tensile_polynomial(door, c, (tensile_stretch){first, end - first, from, to}, 3, 0,
                                   &f));
            all[n++] = f.tau;
        }
    }
    for (int i = 1; i < n; i++) {
        for (int k = i; k > 0 && all[k] < all[k - 1]; k--) {
            const double swap = all[k];
            all[k] = all[k - 1];
            all[k - 1] = swap;
        }
    }
    *tau = n > 0 ? all[n / 2] : 1;

done:
    return st;
}

// the bend (or, of degree 3, the change of bend) in units of its standard error
static status bend_of(const gsl_line_door *door, const tensile_curve *c, double from, double to,
                      int degree, double tau, double least, double *worst)
{
    status st = OK;
    tensile_fit f;
    const tensile_stretch s = stretch_between(c, from, to);
    if (s.count < FEWEST) {
        return OK; // nothing to be seen
    }
    TRY(tensile_polynomial(door, c, s, degree, tau, &f));
    const double size = fabs(f.p[degree]) / fmax(f.se[degree], least);
    *worst = fmax(*worst, size);

done:
    return st;
}

static status straightness(const gsl_line_door *door, const tensile_curve *c, tensile_stretch s,
                           double tau, double least, double *worst)
{
    status st = OK;
    const double middle = 0.5 * (s.from + s.to), quarter = 0.25 * (3 * s.from + s.to);
    *worst = 0;
    TRY(bend_of(door, c, s.from, s.to, 2, tau, least, worst));
    if (*worst > straight_limit) {
        return OK;
    }
    TRY(bend_of(door, c, s.from, s.to, 3, tau, least, worst));
    TRY(bend_of(door, c, s.from, middle, 2, tau, least, worst));
    TRY(bend_of(door, c, middle, s.to, 2, tau, least, worst));
    TRY(bend_of(door, c, s.from, quarter, 2, tau, least, worst));

done:
    return st;
}

// The slope at zero stress, y' = p1 + 2 p2 t0 at t0 = -p0/p1, not further out than `furthest`
// (9.80)
static void slope_at_zero(const tensile_fit *f, double t0, double *E, double *variance)
{
    const double g[CUBIC] = {0, 1, 2 * t0, 0};
    *E = *variance = 0;
    for (int i = 0; i < CUBIC; i++) {
        *E += g[i] * f->p[i];
        for (int k = 0; k < CUBIC; k++) {
            *variance += g[i] * f->V[i][k] * g[k];
        }
    }
}

static status modulus_of(const gsl_line_door *door, const tensile_curve *c, double tau,
                         tensile_choice *out)
{
    status st = OK;
    tensile_fit *f = &out->fit;
    const tensile_stretch s = out->stretch;
    double slope = 0, variance = 0;
    TRY(tensile_polynomial(door, c, s, 2, 0, f));
    if (f->tau < tau) {
        TRY(tensile_polynomial(door, c, s, 2, tau, f));
    }
    out->se = INFINITY;
    if (f->p[1] <= 0) {
        return OK;
    }
    const double t0 = fmin(fmax(-f->p[0] / f->p[1], -furthest), furthest);
    const double unit = f->scale / (s.to - s.from);
    slope_at_zero(f, t0, &slope, &variance);
    out->E = unit * slope;
    out->se = unit * sqrt(fmax(variance, 0));
    const double stress = f->p[0] + f->p[1] * t0 + f->p[2] * t0 * t0;
    out->zero = s.from + t0 * (s.to - s.from) - stress * f->scale / out->E;

done:
    return st;
}

// the longest straight stretch from `from` on; count 0: none
static status longest(const gsl_line_door *door, const tensile_curve *c, double from, double tau,
                      double least, tensile_choice *out)
{
    status st = OK;
    const double begin = c->strain[0], end = c->strain[c->n - 1];
    for (double to = end; to > from; to = from + end_step * (to - from)) {
        double worst = 0;
        const tensile_stretch s = stretch_between(c, from, to);
        if (s.count < FEWEST) {
            break;
        }
        TRY(straightness(door, c, s, tau, least, &worst));
        if (worst > straight_limit) {
            continue;
        }
        const double part = worst < surely_straight ? 1 : shorten;
        const double later = begin + longer_toe * (from - begin);
        const double start = fmax(later, begin + least_start * (to - begin));
        const double reach = from + part * (to - from);
        out->stretch = stretch_between(c, start, reach);
        if (reach > start && out->stretch.count >= FEWEST) {
            TRY(modulus_of(door, c, tau, out));
            return OK;
        }
    }
    out->stretch.count = 0;

done:
    return st;
}

// Whether the curve soon rises above the stretch's line, surely and by more than a straight one
// may: then the stretch lies in the toe, or where the sample was still slack               (9.88)
static bool lies_in_toe(const tensile_curve *c, const tensile_choice *w)
{
    const double length = w->stretch.to - w->stretch.from;
    for (int k = 0; k < TOE_LENGTHS; k++) {
        const double from = w->stretch.to + k * length;
        const tensile_stretch s = stretch_between(c, from, from + length);
        double above = 0, along = 0;
        for (int i = s.first; i < s.first + s.count; i++) {
            above += (c->stress[i] - w->E * (c->strain[i] - w->zero)) / s.count;
            along += fmax(c->strain[i] - w->zero, 0) / s.count;
        }
        const double chance =
            hypot(w->se * along, w->fit.noise * sqrt(w->fit.tau / fmax(s.count, 1)));
        if (s.count > 0 && above > toe_rise * w->E * along + sure * chance) {
            return true;
        }
    }
    return false;
}

// The one with the least standard error, as a share of its modulus, of those that are not surely
// less steep than another. Only what is itself sure has a say in that: among so many short ones
// some are steep by chance.
static int best_of(int n, const tensile_choice *all)
{
    double least = INFINITY, steepest = 0;
    int best = -1;
    for (int i = 0; i < n; i++) {
        least = fmin(least, all[i].se);
    }
    for (int i = 0; i < n; i++) {
        if (all[i].se < fmax(well_known * all[i].E, 2 * least)) {
            steepest = fmax(steepest, all[i].E - sure * all[i].se);
        }
    }
    for (int i = 0; i < n; i++) {
        const bool steep = all[i].E + sure * all[i].se >= steepest;
        if (steep && all[i].E > 0 &&
            (best < 0 || all[i].se / all[i].E < all[best].se / all[best].E)) {
            best = i;
        }
    }
    return best;
}

static status best_straight(const gsl_line_door *door, const tensile_curve *c,
                            const tensile_curve *whole, double tau, double least,
                            tensile_choice *out, bool *found)
{
    enum { MOST = 32 };
    status st = OK;
    tensile_choice all[MOST];
    int n = 0;
    const double begin = c->strain[0], size = c->strain[c->n - 1] - begin;
    for (double toe = 0; toe < toe_most && n < MOST; toe = fmax(toe_step * toe, toe_least)) {
        all[n] = (tensile_choice){.E = 0};
        TRY(longest(door, c, begin + toe * size, tau, least, &all[n]));
        if (all[n].stretch.count > 0 && isfinite(all[n].se) && !lies_in_toe(whole, &all[n])) {
            n++;
        }
    }
    const int best = best_of(n, all);
    *found = best >= 0 && all[best].E > 0;
    if (*found) {
        *out = all[best];
    }

done:
    return st;
}

status tensile_choose(const gsl_line_door *door, const tensile_curve *c, const tensile_curve *whole,
                      tensile_choice *out)
{
    status st = OK;
    double tau = 1;
    bool found = false;
    TRY(local_correlation(door, c, &tau));
    for (double least = least_bend; !found && least < most_bend; least *= more_bend) {
        TRY(best_straight(door, c, whole, tau, least, out, &found));
        if (found && least > least_bend) { // the bend that was let pass is in the interval
            const double unit = out->fit.scale / (out->stretch.to - out->stretch.from);
            out->se = hypot(out->se, straight_limit * least * unit);
        }
    }
    if (!found) {
        TRY(status_fail(ERR_FILE, "no straight stretch of %d points where stress rises with strain",
                        FEWEST));
    }

done:
    return st;
}
