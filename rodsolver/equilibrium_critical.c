// rodsolver/equilibrium_critical.c
// Critical points on the way: bifurcations between two points of it, limit points by arclength.
// docs/theory.md (4.24)
#include "rodsolver/equilibrium_path.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SEARCH_STEPS = 60, ARC_STEPS = 2000, ARC_CORRECTIONS = 8 };

// two crossings nearer to each other, as parts of the way, are one
static const double one_place = 2e-3;
// part of the determinant at both ends below which its parabola asks for a look between
static const double suspicious = 0.6;
// a search that stops early is believed with a bracket this narrow; else the step was too long
static const double narrow_enough = 1e-6;
// the width of the bracket at which a search stops, of the factor
static const double search_width = 1e-10;
// ... and of an arclength step
static const double arc_width = 1e-3;
// corrections while searching; at a limit point, whose factor they enter by their square
static const double search_tolerance = 1e-9, singular_tolerance = 1e-6, stalled = 0.1;

// --- between two points of the way, kept in e->old and e->direction

// what tells one side of a critical point from the other
static int character(const equilibrium *e)
{
    return e->conservative ? e->negative : e->determinant;
}

// From between the two points to the equilibrium at this factor. Both belong to one smooth piece of
// the way, so that it is near; false where Newton's method goes elsewhere
static bool solve_between(equilibrium *e, double left, double right, double factor)
{
    const double share = (factor - left) / (right - left);
    for (int i = 0; i < e->plan->nstation; i++) {
        const vec6 change = vec6_sub(e->direction[i], e->old[i]);
        e->xi[i] = vec6_add(e->old[i], vec6_scale(share, change));
        e->arc_step[i] = change;
    }
    for (int i = 0; i < e->rod->ntendon; i++) {
        e->tension[i] = e->tension_old[i] + share * (e->tension_direction[i] - e->tension_old[i]);
    }
    const double apart = newton_size(e, e->arc_step);
    double moved;
    path_factor(e, factor);
    return newton_correct(e, search_tolerance, 2 * ARC_CORRECTIONS, &moved) &&
           moved <= fmax(0.5 * apart, 1e-3) && newton_linearize(e);
}

typedef struct bracket {
    double a, b;     // factors; the character at a is that of the left point
    int left, right; // characters at a and b
    double fa, fb;   // values of the function whose sign tells the side
    double log_left; // of the determinant at the left point
} bracket;

// The determinant over the one at the left point, as a function that crosses zero once: its root of
// the order in which it vanishes, with the sign of "not yet passed"
static double crossing_value(const equilibrium *e, const bracket *s)
{
    const int order = e->conservative && character(e) != s->left ? abs(character(e) - s->left) : 1;
    const double size = exp((sweep_log_determinant(e) - s->log_left) / order);
    return character(e) == s->left ? size : -size;
}

// Illinois, with a bisection now and then: the determinant is smooth along the way
static bool narrow(equilibrium *e, double left, double right, bracket *s)
{
    int side = 0;
    for (int k = 0; k < SEARCH_STEPS && s->b - s->a > search_width; k++) {
        double c = k % 4 == 3 ? (s->a + s->b) / 2 : (s->a * s->fb - s->b * s->fa) / (s->fb - s->fa);
        c = c > s->a && c < s->b ? c : (s->a + s->b) / 2;
        if (!solve_between(e, left, right, c)) {
            break;
        }
        const double f = crossing_value(e, s);
        if (f > 0) {
            s->a = c;
            s->fa = f;
            s->fb = side == 1 ? s->fb / 2 : s->fb;
            side = 1;
        } else {
            s->b = c;
            s->fb = f;
            s->right = character(e);
            s->fa = side == -1 ? s->fa / 2 : s->fa;
            side = -1;
        }
    }
    return s->b - s->a <= narrow_enough;
}

typedef struct right_end {
    double factor, log_determinant;
    int negative, determinant;
} right_end;

static right_end keep_right(equilibrium *e)
{
    memcpy(e->direction, e->xi, (size_t)e->plan->nstation * sizeof *e->xi);
    memcpy(e->tension_direction, e->tension, (size_t)e->rod->ntendon * sizeof *e->tension);
    return (right_end){e->factor, sweep_log_determinant(e), e->negative, e->determinant};
}

static bool back_to_right(equilibrium *e, const right_end *r)
{
    memcpy(e->xi, e->direction, (size_t)e->plan->nstation * sizeof *e->xi);
    memcpy(e->tension, e->tension_direction, (size_t)e->rod->ntendon * sizeof *e->tension);
    path_factor(e, r->factor);
    const bool good = newton_linearize(e);
    e->negative = r->negative;
    e->determinant = r->determinant;
    return good;
}

// all crossings from s->left's character at s->a to `last` at `end`, one after the other
static bool find_all(equilibrium *e, path *way, const right_end *r, bracket *s, double end,
                     int last, double log_end)
{
    bool found = true;
    while (found && s->left != last) {
        const int order = e->conservative ? abs(last - s->left) : 1;
        s->b = end;
        s->right = last;
        s->fa = 1;
        s->fb = -exp((log_end - s->log_left) / order);
        found = narrow(e, way->factor, r->factor, s);
        if (found) {
            path_record(way, CRITICAL_BIFURCATION, (s->a + s->b) / 2,
                        e->conservative ? s->right : -1);
            s->a = s->b;
            s->left = s->right;
        }
    }
    return found;
}

static bracket bracket_at_left(const equilibrium *e, const path *way)
{
    return (bracket){.a = way->factor,
                     .left = e->conservative ? way->negative : way->determinant,
                     .log_left = way->log_determinant};
}

// Where between the kept point and the present one the determinant might reach 0 and come back: the
// lowest point of the parabola through the last three; NAN where it stays well above
static double lowest_between(const equilibrium *e, const path *way)
{
    if (!(way->earlier < way->factor)) {
        return NAN;
    }
    const double d0 = exp(way->earlier_log - way->log_determinant);
    const double d2 = exp(sweep_log_determinant(e) - way->log_determinant);
    const double h0 = way->factor - way->earlier, h2 = e->factor - way->factor;
    const double s0 = (1 - d0) / h0, s2 = (d2 - 1) / h2, bend = (s2 - s0) / (h0 + h2);
    const double slope = s0 + bend * h0, at = -slope / (2 * bend);
    const bool inside = bend > 0 && at > 0 && at < h2;
    const double lowest = 1 + at * (slope + at * bend);
    return inside && lowest < suspicious * fmin(1, d2) ? way->factor + at : NAN;
}

bool path_examine(equilibrium *e, path *way)
{
    const right_end r = keep_right(e);
    const int left = e->conservative ? way->negative : way->determinant, last = character(e);
    const double share = e->factor - way->factor;
    bracket s = bracket_at_left(e, way);
    const int ncritical = way->ncritical;
    bool good = true;
    if (left != last) {
        // two at once are two that a shorter step tells apart, or another equilibrium
        if (e->conservative && abs(last - left) > 1 && share > one_place) {
            return false;
        }
        good = find_all(e, way, &r, &s, r.factor, last, r.log_determinant);
    } else {
        const double between = lowest_between(e, way);
        if (isnan(between)) {
            return true;
        }
        good = solve_between(e, way->factor, r.factor, between);
        const int middle = character(e);
        if (good && middle != left) {
            const double log_middle = sweep_log_determinant(e);
            good = find_all(e, way, &r, &s, between, middle, log_middle) &&
                   find_all(e, way, &r, &s, r.factor, last, r.log_determinant);
        }
    }
    way->ncritical = good ? way->ncritical : ncritical;
    return back_to_right(e, &r) && good;
}

// --- arclength

// The tangent of the way at e, oriented along the last one: strains in e->direction (unit in the
// product with the factor), its component along the factor returned
static double arc_tangent(equilibrium *e, bool first, double last)
{
    newton_slope(e);
    const double size = sqrt(path_product(e, e->slope, e->slope) + 1);
    const double along = first ? 1 : path_product(e, e->slope, e->direction) + last;
    const double sign = along < 0 ? -1 : 1;
    for (int i = 0; i < e->plan->nstation; i++) {
        e->direction[i] = vec6_scale(sign / size, e->slope[i]);
    }
    for (int i = 0; i < e->rod->ntendon; i++) {
        e->tension_direction[i] = sign / size * e->tension_slope[i];
    }
    return sign / size;
}

// Corrects across the direction of the step, the factor being free
static bool arc_correct(equilibrium *e, double along, double *moved)
{
    double before = HUGE_VAL;
    *moved = 0;
    for (int k = 0; k < ARC_CORRECTIONS; k++) {
        if (!newton_linearize(e)) {
            return false;
        }
        newton_step(e);
        memcpy(e->arc_step, e->step, (size_t)e->plan->nstation * sizeof *e->step);
        memcpy(e->arc_tension, e->tension_step, (size_t)e->rod->ntendon * sizeof(double));
        newton_slope(e);
        const double change = -path_product(e, e->direction, e->arc_step) /
                              (path_product(e, e->direction, e->slope) + along);
        for (int i = 0; i < e->plan->nstation; i++) {
            e->step[i] = vec6_add(e->arc_step[i], vec6_scale(change, e->slope[i]));
        }
        for (int i = 0; i < e->rod->ntendon; i++) {
            e->tension_step[i] = e->arc_tension[i] + change * e->tension_slope[i];
        }
        const double size = newton_size(e, e->step);
        if (!isfinite(size) || (k > 1 && size > before && size > singular_tolerance)) {
            return false;
        }
        newton_advance(e, newton_longest_share(e), e->step, e->tension_step);
        path_factor(e, e->factor + change);
        *moved += size;
        e->iterations++;
        // where the tangent is nearly singular its two parts cancel: rounding stops the way down
        const bool stopped = k > 2 && size > stalled * before && size <= singular_tolerance;
        if (stopped || size * fmin(1, k > 0 ? size / before : 1) <= search_tolerance) {
            return true;
        }
        before = size;
    }
    return false;
}

typedef struct arc_point {
    double factor, along; // along: the tangent's component along the factor
    int negative, determinant;
    double log_determinant;
} arc_point;

// From the kept point by `step` along e->direction; false: shorter
static bool arc_step(equilibrium *e, const arc_point *from, double step, double *moved)
{
    path_restore(e);
    newton_advance(e, step, e->direction, e->tension_direction);
    path_factor(e, from->factor + step * from->along);
    return arc_correct(e, from->along, moved) && *moved <= fmax(0.3 * step, 1e-6);
}

// d factor / d step at e, on the way from a kept point along e->direction
static double arc_rate(equilibrium *e, const arc_point *from)
{
    newton_slope(e);
    return 1 / (path_product(e, e->direction, e->slope) + from->along);
}

typedef struct arc_end {
    double step, factor, rate;
} arc_end;

// the extreme factor between two ends of opposite rates, by the cubic through both
static double extreme_between(const arc_end *a, const arc_end *b)
{
    const double h = b->step - a->step, mean = (b->factor - a->factor) / h;
    // rate at t in [0, 1]: a->rate + 2 p t + 3 q t^2
    const double q = a->rate + b->rate - 2 * mean, p = 3 * mean - 2 * a->rate - b->rate;
    const double root = sqrt(fmax(p * p - 3 * q * a->rate, 0));
    const double t = a->rate / (-p + (a->rate > 0 ? root : -root));
    return a->factor + h * t * (a->rate + t * (p + t * q));
}

// the limit point between the kept point and the end `b`: where the factor has no rate along the
// step. Right at it nothing can be solved for: from a narrow bracket the cubic tells
static bool arc_find_limit(equilibrium *e, const arc_point *from, arc_end b, double *limit)
{
    arc_end a = {0, from->factor, from->along};
    const double whole = b.step;
    double fa = a.rate, fb = b.rate;
    int side = 0;
    for (int k = 0; k < SEARCH_STEPS && b.step - a.step > arc_width * whole; k++) {
        const double c =
            k % 3 == 2 ? (a.step + b.step) / 2 : (a.step * fb - b.step * fa) / (fb - fa);
        double moved;
        if (!arc_step(e, from, c, &moved) || !newton_linearize(e)) {
            break;
        }
        const arc_end here = {c, e->factor, arc_rate(e, from)};
        const bool before = (here.rate > 0) == (from->along > 0);
        if (before) {
            a = here;
            fb = side == 1 ? fb / 2 : fb;
            fa = here.rate;
        } else {
            b = here;
            fa = side == -1 ? fa / 2 : fa;
            fb = here.rate;
        }
        side = before ? 1 : -1;
    }
    *limit = extreme_between(&a, &b);
    return b.step - a.step <= 0.1 * whole;
}

static arc_point arc_point_here(const equilibrium *e, double along)
{
    return (arc_point){e->factor, along, e->negative, e->determinant, sweep_log_determinant(e)};
}

// arrives at factor 1 between the kept point and the present one
static int arc_arrive(equilibrium *e, path *way, const arc_point *from, double tolerance)
{
    const double share = (1 - from->factor) / (e->factor - from->factor);
    for (int i = 0; i < e->plan->nstation; i++) {
        const vec6 change = vec6_sub(e->xi[i], e->old[i]);
        e->xi[i] = vec6_add(e->old[i], vec6_scale(share, change));
    }
    double moved;
    path_factor(e, 1);
    if (!newton_correct(e, tolerance, 2 * ARC_CORRECTIONS, &moved)) {
        return PATH_LOST;
    }
    way->factor = 1;
    way->negative = e->negative;
    way->determinant = e->determinant;
    return PATH_ARRIVED;
}

int path_turn(equilibrium *e, path *way, double tolerance)
{
    // the points of the way are rough: across a short step that would be all there is
    double moved;
    if (!newton_linearize(e) || !arc_correct(e, arc_tangent(e, true, 0), &moved) ||
        !newton_linearize(e)) {
        return PATH_LOST;
    }
    arc_point from = arc_point_here(e, arc_tangent(e, true, 0));
    double step = 0.1;
    int straight = 0;
    for (int k = 0; k < ARC_STEPS; k++) {
        path_keep(e);
        if (!arc_step(e, &from, step, &moved)) {
            step /= 3;
            path_restore(e);
            if (step < 1e-7) {
                return PATH_LOST;
            }
            continue;
        }
        if (e->factor >= 1 && from.along > 0) {
            return arc_arrive(e, way, &from, tolerance);
        }
        if (!newton_linearize(e)) {
            return PATH_LOST;
        }
        const double rate = arc_rate(e, &from);
        if ((rate > 0) != (from.along > 0)) {
            const int behind = e->conservative ? e->negative : -1;
            double limit;
            if (!arc_find_limit(e, &from, (arc_end){step, e->factor, rate}, &limit)) {
                return PATH_LOST;
            }
            path_record(way, CRITICAL_LIMIT, limit, behind);
            if (!way->past) {
                way->factor = limit;
                return PATH_LIMIT;
            }
            // on from the point behind the limit
            if (!arc_step(e, &from, step, &moved) || !newton_linearize(e)) {
                return PATH_LOST;
            }
            straight = 0;
        } else if (e->conservative ? e->negative != from.negative
                                   : e->determinant != from.determinant) {
            path_record(way, CRITICAL_BIFURCATION, (from.factor + e->factor) / 2,
                        e->conservative ? e->negative : -1);
        }
        const double next = arc_tangent(e, false, from.along);
        straight = next > 0 ? straight + 1 : 0;
        from = arc_point_here(e, next);
        step *= fmin(2, fmax(0.3, sqrt(0.05 * step / fmax(moved, 1e-9))));
        step = fmin(step, 0.5);
        if (!way->past && straight > 8 && next > 0.3) {
            break;
        }
    }
    way->factor = e->factor;
    way->negative = e->negative;
    way->determinant = e->determinant;
    way->log_determinant = sweep_log_determinant(e);
    return PATH_ARRIVED;
}
