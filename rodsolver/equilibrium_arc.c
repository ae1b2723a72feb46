// rodsolver/equilibrium_arc.c
// The way by arclength, where the factor cannot grow: limit points. docs/theory.md (4.24)
#include "rodsolver/equilibrium_path.h"

#include <math.h>
#include <string.h>

enum { SEARCH_STEPS = 60, ARC_STEPS = 2000, ARC_CORRECTIONS = 8 };

// the width of the bracket at which a search stops, of the factor and of an arclength step
static const double search_width = 1e-10, arc_width = 1e-3;
// steps in the turn of the rod and the factor, and the part of a step that corrections aim at
static const double first_arc = 0.1, longest_arc = 0.5, least_arc = 1e-7, arc_aim = 0.05;
// corrections; at a limit point, whose factor they enter by their square
static const double search_tolerance = 1e-9, singular_tolerance = 1e-6, stalled = 0.1;

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

static int arc_character(const equilibrium *e)
{
    return e->conservative ? e->negative : e->determinant;
}

// the factor at which the determinant crosses zero between the kept point and the one `step`
// further
static double arc_find_crossing(equilibrium *e, const arc_point *from, double step)
{
    const int left = e->conservative ? from->negative : from->determinant;
    double a = 0, b = step, fa = 1, fb = -exp(sweep_log_determinant(e) - from->log_determinant);
    double at_a = from->factor, at_b = e->factor;
    for (int k = 0; k < SEARCH_STEPS && fabs(at_b - at_a) > search_width; k++) {
        const double c = k % 3 == 2 ? (a + b) / 2 : (a * fb - b * fa) / (fb - fa);
        double moved;
        if (!arc_step(e, from, c, &moved) || !newton_linearize(e)) {
            break;
        }
        const double size = exp(sweep_log_determinant(e) - from->log_determinant);
        const bool before = arc_character(e) == left;
        a = before ? c : a;
        fa = before ? size : fa;
        at_a = before ? e->factor : at_a;
        b = before ? b : c;
        fb = before ? fb : -size;
        at_b = before ? at_b : e->factor;
    }
    return (at_a + at_b) / 2;
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

// the points of the way are rough: across a short step that would be all there is
static bool arc_start(equilibrium *e, arc_point *from)
{
    double moved;
    if (!newton_linearize(e) || !arc_correct(e, arc_tangent(e, true, 0), &moved) ||
        !newton_linearize(e)) {
        return false;
    }
    *from = arc_point_here(e, arc_tangent(e, true, 0));
    return true;
}

static int behind(const equilibrium *e)
{
    return e->conservative ? e->negative : -1;
}

enum { ARC_ON, ARC_SHORTER, ARC_STOP, ARC_LOST };

// a limit point between the kept point and the present one, where the factor grows at this rate
static int pass_limit(equilibrium *e, path *way, const arc_point *from, double step, double rate)
{
    const int negative = behind(e);
    double limit, moved;
    int tendon, station;
    if (!arc_find_limit(e, from, (arc_end){step, e->factor, rate}, &limit)) {
        return ARC_LOST;
    }
    if (limit > 1) {
        return ARC_SHORTER; // the request lies before it
    }
    if (balance_finds_eaten(e, &tendon, &station)) {
        return ARC_LOST;
    }
    path_record(way, CRITICAL_LIMIT, limit, negative);
    if (!way->past) {
        way->factor = limit;
        return ARC_STOP;
    }
    return arc_step(e, from, step, &moved) && newton_linearize(e) ? ARC_ON : ARC_LOST;
}

static int pass_crossing(equilibrium *e, path *way, const arc_point *from, double step)
{
    const int negative = behind(e);
    double moved;
    path_record(way, CRITICAL_BIFURCATION, arc_find_crossing(e, from, step), negative);
    return arc_step(e, from, step, &moved) && newton_linearize(e) ? ARC_ON : ARC_LOST;
}

// what lies between the kept point and the present one
static int pass(equilibrium *e, path *way, const arc_point *from, double step)
{
    if (!newton_linearize(e)) {
        return ARC_LOST;
    }
    const double rate = arc_rate(e, from);
    if ((rate > 0) != (from->along > 0)) {
        return pass_limit(e, way, from, step, rate);
    }
    const int left = e->conservative ? from->negative : from->determinant;
    return arc_character(e) != left ? pass_crossing(e, way, from, step) : ARC_ON;
}

static int arc_leave(const equilibrium *e, path *way)
{
    way->factor = e->factor;
    way->negative = e->negative;
    way->determinant = e->determinant;
    way->log_determinant = sweep_log_determinant(e);
    return PATH_ARRIVED;
}

int path_turn(equilibrium *e, path *way, double tolerance)
{
    arc_point from;
    double step = first_arc;
    int straight = 0, tendon, station;
    if (!arc_start(e, &from)) {
        return PATH_LOST;
    }
    for (int k = 0; k < ARC_STEPS; k++) {
        double moved = 0;
        if (e->iterations > way->most || step < least_arc ||
            balance_finds_eaten(e, &tendon, &station)) {
            return PATH_LOST;
        }
        path_keep(e);
        int next = arc_step(e, &from, step, &moved) ? ARC_ON : ARC_SHORTER;
        if (next == ARC_ON && e->factor >= 1 && from.along > 0) {
            return arc_arrive(e, way, &from, tolerance);
        }
        next = next == ARC_ON ? pass(e, way, &from, step) : next;
        if (next == ARC_LOST || next == ARC_STOP) {
            return next == ARC_STOP ? PATH_LIMIT : PATH_LOST;
        }
        if (next == ARC_SHORTER) {
            step /= 3;
            path_restore(e);
            continue;
        }
        const double along = arc_tangent(e, false, from.along);
        // back to natural steps where the factor has grown for a while
        straight = along > 0 && from.along > 0 ? straight + 1 : 0;
        from = arc_point_here(e, along);
        step *= fmin(2, fmax(0.3, sqrt(arc_aim * step / fmax(moved, 1e-9))));
        step = fmin(step, longest_arc);
        if (!way->past && straight > 8 && along > 0.3) {
            break;
        }
    }
    return arc_leave(e, way);
}
