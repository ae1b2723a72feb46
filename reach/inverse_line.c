// reach/inverse_line.c
// One bending joint: every solution.
#include "reach/inverse_inside.h"

#include "reach/arc.h"

enum { MOST_ROOTS = 64, NEWTON_STEPS = 12, GOLDEN_STEPS = 48 };

// --- the roots

// Nearer than this share of the length is rounding.
static const double exact = 1e-14;

// on the scope itself: rho(u)^2 = rho^2 by Newton's steps from the cubics' root, with the cubics'
// slope, which is the analytic one at the nodes; keeps the best
static status polish(const inverse *inv, scope_state *state, double rho, double *u)
{
    status st = OK;
    const scope *s = inv->scope;
    double q[SCOPE_JOINTS] = {0}, best = INFINITY;
    double x = *u;
    for (int i = 0; i < NEWTON_STEPS; i++) {
        vec3 tip;
        const vec3 slope = bend_sweep_at(&inv->sweep, x).slope;
        q[SCOPE_BEND] = x;
        TRY(scope_bend(state, q));
        TRY(scope_bent_tip(state, &tip, NULL));
        const double away = hypot(tip.a[0], tip.a[1]), miss = fabs(away - rho);
        if (!(miss < best)) {
            break;
        }
        best = miss;
        *u = x;
        const double grows = 2 * (tip.a[0] * slope.a[0] + tip.a[1] * slope.a[1]);
        const double step = (away + rho) * (away - rho) / grows;
        if (!isfinite(step) || miss <= exact * s->length) {
            break;
        }
        x = fmin(fmax(x - step, s->low[SCOPE_BEND]), s->high[SCOPE_BEND]);
    }

done:
    return st;
}

static status keep_root(scope_state *state, vec3 target, cylinder_point c, double u,
                        inverse_answer *out)
{
    status st = OK;
    inverse_pose pose = {{0}, 0};
    vec3 bent;
    pose.q[SCOPE_BEND] = u;
    TRY(scope_bend(state, pose.q));
    TRY(scope_bent_tip(state, &bent, NULL));
    (void)inverse_on_line(scope_of(state), c, bent, pose.q);
    TRY(inverse_miss(state, target, &pose));
    inverse_keep(scope_of(state), &pose, out);

done:
    return st;
}

// An end of the range whose tip is as far as the target but for this share of the length is a root.
static const double end_rounding = 1e-12;

static status end_roots(const inverse *inv, scope_state *state, vec3 target, cylinder_point c,
                        inverse_answer *out)
{
    status st = OK;
    const bend_sweep *w = &inv->sweep;
    for (int i = 0; i < 2; i++) {
        const bend_node *end = &w->node[i * (w->nnode - 1)];
        const double off = hypot(end->tip.a[0], end->tip.a[1]) - c.rho;
        if (fabs(off) <= end_rounding * inv->scope->length) {
            TRY(keep_root(state, target, c, end->u, out));
        }
    }

done:
    return st;
}

static status roots(const inverse *inv, scope_state *state, vec3 target, cylinder_point c,
                    inverse_answer *out)
{
    status st = OK;
    const scope *s = inv->scope;
    double u[MOST_ROOTS];
    if (s->rod) {
        out->starts = bend_sweep_roots(&inv->sweep, c.rho, MOST_ROOTS, u);
    } else {
        out->starts = arc_bends(s->length, c.rho, s->low[SCOPE_BEND], s->high[SCOPE_BEND], u);
    }
    for (int i = 0; i < out->starts; i++) {
        if (s->rod) {
            TRY(polish(inv, state, c.rho, &u[i]));
        }
        TRY(keep_root(state, target, c, u[i], out));
    }

done:
    return st;
}

// --- the nearest

static double miss_at(const inverse *inv, cylinder_point c, double u)
{
    double q[SCOPE_JOINTS];
    return inverse_on_line(inv->scope, c, bend_sweep_at(&inv->sweep, u).tip, q);
}

// the least between a and b by golden sections
static double least_between(const inverse *inv, cylinder_point c, double a, double b)
{
    static const double golden = 0.6180339887498949;
    double x = b - golden * (b - a), y = a + golden * (b - a);
    double fx = miss_at(inv, c, x), fy = miss_at(inv, c, y);
    for (int i = 0; i < GOLDEN_STEPS; i++) {
        if (fx < fy) {
            b = y;
            y = x;
            fy = fx;
            x = b - golden * (b - a);
            fx = miss_at(inv, c, x);
        } else {
            a = x;
            x = y;
            fx = fy;
            y = a + golden * (b - a);
            fy = miss_at(inv, c, y);
        }
    }
    // the least may be an end of the range
    const double middle = (a + b) / 2, fm = miss_at(inv, c, middle);
    const double fa = miss_at(inv, c, a), fb = miss_at(inv, c, b);
    return fa <= fm && fa <= fb ? a : fb <= fm ? b : middle;
}

// about the node from which it is least, and every other that is least among its neighbours and
// could, with the way to them, be as near
static double nearest_bend(const inverse *inv, cylinder_point c)
{
    const bend_sweep *w = &inv->sweep;
    double best = INFINITY, at = w->node[0].u, q[SCOPE_JOINTS], miss[3] = {INFINITY};
    miss[1] = inverse_on_line(inv->scope, c, w->node[0].tip, q);
    for (int k = 0; k < w->nnode; k++) {
        const int before = k > 0 ? k - 1 : 0, after = k + 1 < w->nnode ? k + 1 : k;
        miss[2] = after > k ? inverse_on_line(inv->scope, c, w->node[after].tip, q) : INFINITY;
        const double way = w->node[after].tip_moved - w->node[before].tip_moved;
        if (miss[1] <= miss[0] && miss[1] <= miss[2] && miss[1] - way < best) {
            const double u = least_between(inv, c, w->node[before].u, w->node[after].u);
            const double there = miss_at(inv, c, u);
            at = there < best ? u : at;
            best = fmin(there, best);
        }
        miss[0] = miss[1];
        miss[1] = miss[2];
    }
    return at;
}

status inverse_line(const inverse *inv, scope_state *state, vec3 target, inverse_answer *out)
{
    status st = OK;
    const cylinder_point c = cylinder_of(state, target);
    TRY(roots(inv, state, target, c, out));
    TRY(end_roots(inv, state, target, c, out));
    if (out->npose == 0) {
        // of a target at the very end of the reach it is the root
        TRY(keep_root(state, target, c, nearest_bend(inv, c), out));
    }

done:
    return st;
}
