// reach/inverse.c
#include "reach/inverse_inside.h"

#include "base/memory.h"

#include <string.h>

static const double full_turn = 6.283185307179586476925287;
// Rounding of who made the target, in joints over their range or their unit.
static const double limit_rounding = 1e-10;
// Poses nearer than this to each other, in joints over their ranges, are one.
static const double same_pose = 1e-6;

cylinder_point cylinder_of(const scope_state *state, vec3 target)
{
    const pose entry = scope_entry(state);
    const vec3 p = mat3_tmul_vec(entry.R, vec3_sub(target, entry.p));
    return (cylinder_point){hypot(p.a[0], p.a[1]), atan2(p.a[1], p.a[0]), p.a[2]};
}

static double clip(double x, double low, double high)
{
    return fmin(fmax(x, low), high);
}

// the angle equal to `angle` but for full turns that is in the limits or nearest to them; of
// several the smallest
static double turn_within(double angle, double low, double high)
{
    double best = NAN, away = INFINITY;
    const double first = angle + full_turn * floor((low - angle) / full_turn);
    for (double a = first; a < high + full_turn; a += full_turn) {
        const double inside = clip(a, low, high), miss = fabs(a - inside);
        if (miss < away - limit_rounding ||
            (miss < away + limit_rounding && fabs(inside) < fabs(best))) {
            best = inside;
            away = miss;
        }
    }
    return best;
}

double inverse_on_line(const scope *s, cylinder_point target, vec3 bent, double *q)
{
    const double rho = hypot(bent.a[0], bent.a[1]);
    const double turn = rho > 0 && target.rho > 0 ? target.angle - atan2(bent.a[1], bent.a[0]) : 0;
    q[SCOPE_INSERTION] =
        clip(target.z - bent.a[2], s->low[SCOPE_INSERTION], s->high[SCOPE_INSERTION]);
    q[SCOPE_TURN] = turn_within(turn, s->low[SCOPE_TURN], s->high[SCOPE_TURN]);
    // |rho - target.rho e^(i gap)|, without cancelling
    const double gap = rho > 0 && target.rho > 0 ? q[SCOPE_TURN] - turn : 0;
    const double across = 2 * sqrt(rho * target.rho) * sin(gap / 2);
    return hypot(hypot(rho - target.rho, across), target.z - bent.a[2] - q[SCOPE_INSERTION]);
}

status inverse_miss(scope_state *state, vec3 target, inverse_pose *pose)
{
    status st = OK;
    vec3 tip;
    TRY(scope_bend(state, pose->q));
    TRY(scope_tip(state, pose->q, &tip, NULL));
    pose->miss = vec3_norm(vec3_sub(tip, target));

done:
    return st;
}

static double range(const scope *s, int joint)
{
    return s->high[joint] - s->low[joint];
}

static bool same(const scope *s, const inverse_pose *a, const inverse_pose *b)
{
    for (int i = 0; i < s->njoint; i++) {
        if (fabs(a->q[i] - b->q[i]) > same_pose * range(s, i)) {
            return false;
        }
    }
    return true;
}

void inverse_keep(const scope *s, const inverse_pose *pose, inverse_answer *out)
{
    if (pose->miss < out->nearest.miss) {
        out->nearest = *pose;
    }
    if (!(pose->miss <= INVERSE_EXACT) || out->npose == INVERSE_POSES) {
        return;
    }
    for (int i = 0; i < out->npose; i++) {
        if (same(s, pose, &out->pose[i])) {
            return;
        }
    }
    out->pose[out->npose++] = *pose;
}

// --- why not

// A joint at its limit holds the tip back when it would bring it nearer by this share of the miss
// over its whole range.
static const double holds_back = 1e-3;

// the joint at a limit that would bring the tip nearest if it could go on
static status limit_of(scope_state *state, vec3 target, inverse_answer *out)
{
    status st = OK;
    const scope *s = scope_of(state);
    const double *q = out->nearest.q;
    double J[3 * SCOPE_JOINTS], most = holds_back * out->nearest.miss;
    vec3 tip;
    out->limit = INVERSE_OUT_OF_REACH;
    TRY(scope_bend(state, q));
    TRY(scope_tip(state, q, &tip, J));
    const vec3 away = vec3_scale(1 / out->nearest.miss, vec3_sub(tip, target));
    for (int j = 0; j < s->njoint; j++) {
        const vec3 column = {{J[j], J[s->njoint + j], J[2 * s->njoint + j]}};
        const double size = range(s, j) > 0 ? range(s, j) : 1, near = limit_rounding * size;
        const double grows = size * vec3_dot(away, column);
        const double gain =
            fmax(q[j] <= s->low[j] + near ? grows : 0, q[j] >= s->high[j] - near ? -grows : 0);
        if (gain > most) {
            most = gain;
            out->limit = j;
        }
    }

done:
    return st;
}

status inverse_family(const inverse *inv, scope_state *state, vec3 target, int want,
                      inverse_answer *out)
{
    status st = OK;
    if (scope_of(state) != inv->scope) {
        return status_fail(ERR_BUG, "inverse: a state of another scope");
    }
    for (int i = 0; i < 3; i++) {
        if (!isfinite(target.a[i])) {
            return status_fail(ERR_INPUT, "scope %s: a target that is no point", inv->scope->name);
        }
    }
    out->npose = out->starts = 0;
    out->limit = INVERSE_NO_LIMIT;
    out->nearest = (inverse_pose){.miss = INFINITY};
    if (inv->scope->njoint == SCOPE_BEND + 1) {
        TRY(inverse_line(inv, state, target, out));
    } else {
        TRY(inverse_many(inv, state, target, want, out));
    }
    if (out->npose == 0) {
        TRY(limit_of(state, target, out));
    }

done:
    return st;
}

// poses of a family that are enough for who wants one
enum { USUAL_POSES = 6 };

status inverse_solve(const inverse *inv, scope_state *state, vec3 target, inverse_answer *out)
{
    return inverse_family(inv, state, target, USUAL_POSES, out);
}

// --- made once

status inverse_make(const scope *s, inverse **out)
{
    status st = OK;
    inverse *inv = NULL;
    scope_state *state = NULL;
    const pose entry = pose_identity();
    TRY(scope_state_make(s, &entry, &state));
    TRY(TAKE(inv, 1));
    inv->scope = s;
    if (s->njoint == SCOPE_BEND + 1) {
        TRY(bend_sweep_make(state, &inv->sweep));
    } else {
        TRY(bend_grid_make(state, &inv->grid));
    }
    *out = inv;
    inv = NULL;

done:
    inverse_free(inv);
    scope_state_free(state);
    return st;
}

void inverse_free(inverse *inv)
{
    if (inv) {
        bend_sweep_free(&inv->sweep);
        bend_grid_free(&inv->grid);
        free(inv);
    }
}

double inverse_spacing(const inverse *inv)
{
    double most = inv->grid.spacing;
    for (int k = 1; k < inv->sweep.nnode; k++) {
        most = fmax(most, inv->sweep.node[k].tip_moved - inv->sweep.node[k - 1].tip_moved);
    }
    return most;
}
