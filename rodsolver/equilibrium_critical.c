// rodsolver/equilibrium_critical.c
// Where the tangent changes its character between two points of the way.
// docs/theory.md (4.24)
#include "rodsolver/equilibrium_path.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SEARCH_STEPS = 60, SEARCH_CORRECTIONS = 16 };

// two crossings nearer to each other, as parts of the way, are one
static const double one_place = 2e-3;
// part of the determinant at both ends below which its parabola asks for a look between
static const double suspicious = 0.6;
// a search that stops early is believed with a bracket this narrow; else the step was too long
static const double narrow_enough = 1e-6;
// the width of the bracket at which a search stops, of the factor
static const double search_width = 1e-10;
// corrections while searching
static const double search_tolerance = 1e-9;

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
    return newton_correct(e, search_tolerance, SEARCH_CORRECTIONS, &moved) &&
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
