// rodsolver/equilibrium_path.c
// From one equilibrium to the next along the factor of the loads: predictor and corrector with step
// control. Where the factor cannot grow the way goes on by arclength. docs/theory.md (4.23)
#include "rodsolver/equilibrium_path.h"

#include "rodsolver/collocation.h"

#include <math.h>
#include <string.h>

// corrections that steps aim at, and the largest that is believed: against another equilibrium
// nearby, a correction must also stay below a part of the step itself
static const double aim = 0.15, largest = 0.5, largest_share = 0.4, always = 0.03;
static const double first_turn = 1; // of the first step
static const double rough = 3e-3;   // what is left on the way, before the last point
static const double steep = 3;      // slopes from here on ask for sharper points
static const double least_step = 1e-6;
static const double shortest = 0.02, growth = 3, shrink = 0.35;
enum { PATH_STEPS = 5000, PATH_CORRECTIONS = 7 };

double path_product(const equilibrium *e, const vec6 *a, const vec6 *b)
{
    const plan *p = e->plan;
    const double length = e->rod->length;
    double sum = 0;
    for (int i = 0; i < p->nstation; i++) {
        const double *x = a[i].a, *y = b[i].a;
        sum += gauss_weight[i % GAUSS_STATIONS] * panel_length(p, i / GAUSS_STATIONS) *
               ((x[0] * y[0] + x[1] * y[1] + x[2] * y[2]) / length +
                (x[3] * y[3] + x[4] * y[4] + x[5] * y[5]) * length);
    }
    return sum;
}

void path_keep(equilibrium *e)
{
    memcpy(e->old, e->xi, (size_t)e->plan->nstation * sizeof *e->xi);
    memcpy(e->tension_old, e->tension, (size_t)e->rod->ntendon * sizeof *e->tension);
}

void path_restore(equilibrium *e)
{
    memcpy(e->xi, e->old, (size_t)e->plan->nstation * sizeof *e->xi);
    memcpy(e->tension, e->tension_old, (size_t)e->rod->ntendon * sizeof *e->tension);
}

void path_factor(equilibrium *e, double factor)
{
    e->factor = factor;
    loads_at_factor(e);
}

void path_record(path *way, int kind, double fraction, int negative)
{
    // where there is no room the first ones stay, and the limit point that ends the way
    if (way->ncritical == ROD_MAX_CRITICAL && kind != CRITICAL_LIMIT) {
        return;
    }
    way->ncritical -= way->ncritical == ROD_MAX_CRITICAL;
    way->critical[way->ncritical++] =
        (rod_critical){.kind = kind, .fraction = fraction, .negative = negative};
}

bool path_try(equilibrium *e, double factor, double tolerance, double predicted, double *moved)
{
    path_factor(e, factor);
    const bool found = newton_correct(e, tolerance, PATH_CORRECTIONS, moved);
    return found && *moved <= largest && *moved <= fmax(largest_share * predicted, always);
}

static void note_point(const equilibrium *e, path *way)
{
    way->earlier = way->factor;
    way->earlier_log = way->log_determinant;
    way->factor = e->factor;
    way->negative = e->negative;
    way->determinant = e->determinant;
    way->log_determinant = sweep_log_determinant(e);
}

// one natural step from the kept point; false where it must be shorter
static bool step_by_factor(equilibrium *e, double step, double tolerance, double *moved)
{
    const double predicted = step * newton_size(e, e->slope);
    newton_advance(e, step, e->slope, e->tension_slope);
    // the last point is sharp; the tangent of others is one correction old
    return path_try(e, e->factor + step, tolerance, predicted, moved) &&
           (e->factor == 1 || newton_linearize(e));
}

// Between two critical points of a rod in compression lies about an Euler load of a cantilever at
// least: steps are half as long, so that few are passed over in pairs
static double longest_step(const equilibrium *e)
{
    const double pi = 3.14159265358979323846, length = e->rod->length;
    double compression = 0, stiffness = HUGE_VAL;
    for (int i = 0; i < e->plan->nstation; i++) {
        const vec3 p = e->state[i].slope;
        // newton_slope leaves minus the forces' rate here
        compression = fmax(compression, vec3_dot(e->load_rate[i], p) / vec3_norm(p));
        stiffness = fmin(stiffness, fmin(e->plan->K[i].a[3][3], e->plan->K[i].a[4][4]));
    }
    const double euler = pi * pi * stiffness / (4 * length * length);
    return compression > 0 ? euler / (2 * compression) : HUGE_VAL;
}

// Near a limit point the shape changes fast with the factor, and a rough point might lie beyond it
static double rough_tolerance(const equilibrium *e)
{
    const double rate = newton_size(e, e->slope);
    return rough * fmin(1, steep * steep / (rate * rate));
}

static double next_step(double step, double moved)
{
    const double wanted = sqrt(aim / fmax(moved, 1e-12));
    return step * fmin(growth, fmax(shrink, wanted));
}

// Some seconds of work at most, on any plan: ways that are found take a tenth of it and less
static int most_iterations(const equilibrium *e)
{
    return 300000 / (e->plan->npair + 20);
}

int path_follow(equilibrium *e, path *way, double tolerance)
{
    way->most = e->iterations + most_iterations(e);
    path_factor(e, 0);
    if (!newton_linearize(e)) {
        return PATH_LOST;
    }
    note_point(e, way);
    newton_slope(e);
    double step = fmin(1, first_turn / fmax(newton_size(e, e->slope), 1e-12));
    for (int k = 0; k < PATH_STEPS && way->factor < 1 && e->iterations < way->most; k++) {
        double moved = 0;
        // no crumbs before the end
        const double left = 1 - way->factor;
        step = fmin(step, longest_step(e));
        const double share = step >= 0.85 * left ? left : step;
        const bool last = share == left;
        path_keep(e);
        if (!step_by_factor(e, share, last ? tolerance : rough_tolerance(e), &moved)) {
            path_restore(e);
            path_factor(e, way->factor);
            step = share * shrink;
            if (step < shortest * fmin(1, first_turn / newton_size(e, e->slope))) {
                const int turned = path_turn(e, way, tolerance);
                if (turned != PATH_ARRIVED || way->factor == 1) {
                    return turned;
                }
                step = shortest;
                newton_slope(e);
            }
            continue;
        }
        if (!path_examine(e, way)) {
            path_restore(e);
            path_factor(e, way->factor);
            step = share * shrink;
            if (step < least_step) {
                return PATH_LOST;
            }
            continue;
        }
        note_point(e, way);
        if (way->factor == 1) {
            return PATH_ARRIVED;
        }
        newton_slope(e);
        step = next_step(share, moved);
    }
    return way->factor == 1 ? PATH_ARRIVED : PATH_LOST;
}
