// reach/inverse_fit.c
// Least squares of the tip's miss in the joints' limits: Levenberg's and Marquardt's steps of least
// size in joints scaled by their ranges. GSL's search knows no limits and wants no more joints than
// residuals, of which there are three.                                  docs/theory.md (10.5)
#include "reach/inverse_inside.h"

#include <string.h>

enum { MOST_STEPS = 60 };

// The tip is there when it misses by this share of its length: rounding of a rod leaves less.
static const double exact = 1e-11;
// A step that is wanted to be less than this share of the ranges is none.
static const double no_step = 1e-13;
// A search whose step gains less than this share of the miss has found the nearest pose.
static const double no_gain = 1e-4;
// A Jacobian whose step leaves less than this share of the miss does for the next step too.
static const double good_jacobian = 0.05;
// Damping, of the trace of J J^T: to start with, and the range it moves in.
static const double damping_start = 1e-4, damping_least = 1e-12, damping_most = 1e6;

static double range_of(const scope *s, int j)
{
    return s->high[j] - s->low[j];
}

// H x = b, H symmetric and positive definite
static bool solve3(double H[3][3], const double b[3], double x[3])
{
    const vec3 r0 = {{H[0][0], H[0][1], H[0][2]}}, r1 = {{H[1][0], H[1][1], H[1][2]}},
               r2 = {{H[2][0], H[2][1], H[2][2]}};
    const vec3 c0 = vec3_cross(r1, r2), c1 = vec3_cross(r2, r0), c2 = vec3_cross(r0, r1);
    const double det = vec3_dot(r0, c0);
    for (int i = 0; i < 3; i++) {
        x[i] = (c0.a[i] * b[0] + c1.a[i] * b[1] + c2.a[i] * b[2]) / det;
    }
    return det > 0 && isfinite(x[0]) && isfinite(x[1]) && isfinite(x[2]);
}

// S^2 J^T (J S^2 J^T + lambda I)^-1 (-r) in the free joints
static bool step_of(const scope *s, const double *J, const bool *held, vec3 r, double damping,
                    double *step)
{
    const int n = s->njoint;
    double H[3][3] = {{0}}, x[3];
    for (int j = 0; j < n; j++) {
        const double size = held[j] ? 0 : range_of(s, j) * range_of(s, j);
        for (int a = 0; a < 3; a++) {
            for (int b = 0; b < 3; b++) {
                H[a][b] += size * J[a * n + j] * J[b * n + j];
            }
        }
    }
    const double lambda = damping * (H[0][0] + H[1][1] + H[2][2]);
    for (int a = 0; a < 3; a++) {
        H[a][a] += lambda;
    }
    if (!solve3(H, r.a, x)) {
        return false;
    }
    for (int j = 0; j < n; j++) {
        const double size = held[j] ? 0 : range_of(s, j) * range_of(s, j);
        step[j] = -size * (J[j] * x[0] + J[n + j] * x[1] + J[2 * n + j] * x[2]);
    }
    return true;
}

// the step with every joint held that stands at a limit and would leave it; false: none is left
static bool step_within(const scope *s, const double *q, const double *J, vec3 r, double damping,
                        double *step)
{
    bool held[SCOPE_JOINTS] = {false};
    for (int again = 0; again <= s->njoint; again++) {
        bool more = false;
        if (!step_of(s, J, held, r, damping, step)) {
            return false;
        }
        for (int j = 0; j < s->njoint; j++) {
            if ((q[j] <= s->low[j] && step[j] < 0) || (q[j] >= s->high[j] && step[j] > 0)) {
                held[j] = more = true;
            }
        }
        if (!more) {
            return true;
        }
    }
    return false;
}

// q + step in the limits; the turn, where it may be any, goes round instead. How far of the ranges.
static double move(const scope *s, const double *q, const double *step, double *out)
{
    static const double full_turn = 6.283185307179586;
    double most = 0;
    for (int j = 0; j < s->njoint; j++) {
        out[j] = q[j] + step[j];
        if (j == SCOPE_TURN && range_of(s, j) >= full_turn) {
            out[j] -=
                full_turn * (out[j] > s->high[j] ? ceil((out[j] - s->high[j]) / full_turn) : 0);
            out[j] += full_turn * (out[j] < s->low[j] ? ceil((s->low[j] - out[j]) / full_turn) : 0);
        }
        out[j] = fmin(fmax(out[j], s->low[j]), s->high[j]);
        if (range_of(s, j) > 0) {
            most = fmax(most, fabs(step[j]) / range_of(s, j));
        }
    }
    return most;
}

static status miss_of(scope_state *state, vec3 target, inverse_pose *pose, vec3 *r, double *J)
{
    status st = OK;
    vec3 tip;
    TRY(scope_bend(state, pose->q));
    TRY(scope_tip(state, pose->q, &tip, J));
    *r = vec3_sub(tip, target);
    pose->miss = vec3_norm(*r);

done:
    return st;
}

status inverse_fit(scope_state *state, vec3 target, inverse_pose *pose)
{
    status st = OK;
    const scope *s = scope_of(state);
    double J[3 * SCOPE_JOINTS], step[SCOPE_JOINTS], damping = damping_start;
    bool fresh = true; // the Jacobian is that of the pose
    vec3 r;
    TRY(miss_of(state, target, pose, &r, J));
    for (int i = 0; i < MOST_STEPS && pose->miss > exact * s->length; i++) {
        inverse_pose next = *pose;
        vec3 left;
        if (!step_within(s, pose->q, J, r, damping, step) ||
            move(s, pose->q, step, next.q) < no_step || damping > damping_most) {
            break;
        }
        TRY(miss_of(state, target, &next, &left, NULL));
        if (next.miss < pose->miss) {
            const bool good = next.miss < good_jacobian * pose->miss;
            const bool last = fresh && next.miss > (1 - no_gain) * pose->miss;
            *pose = next;
            if (last) {
                break;
            }
            damping = fmax(damping / 10, damping_least);
            r = left;
            if (!good) {
                TRY(miss_of(state, target, pose, &r, J));
            }
            fresh = !good;
        } else if (!fresh) {
            // an old Jacobian may be why
            TRY(miss_of(state, target, pose, &r, J));
            fresh = true;
        } else {
            damping *= 10;
        }
    }

done:
    return st;
}

// --- what leaves the tip where it is

// A direction of which less than this is left once the others are taken out is none of its own.
static const double no_direction = 1e-6;

// takes the parts along the kept rows out; what is left, of a unit row
static double take_out(int n, int kept, double (*row)[SCOPE_JOINTS], double *v)
{
    double left = 0;
    for (int twice = 0; twice < 2; twice++) {
        for (int k = 0; k < kept; k++) {
            double along = 0;
            for (int j = 0; j < n; j++) {
                along += row[k][j] * v[j];
            }
            for (int j = 0; j < n; j++) {
                v[j] -= along * row[k][j];
            }
        }
    }
    for (int j = 0; j < n; j++) {
        left += v[j] * v[j];
    }
    return sqrt(left);
}

int inverse_null_space(const scope *s, const double *jacobian, double (*direction)[SCOPE_JOINTS])
{
    const int n = s->njoint;
    double row[2 * SCOPE_JOINTS][SCOPE_JOINTS];
    int kept = 0, rank = 0;
    // the rows of J S, then every joint alone, by Gram and Schmidt
    for (int i = 0; i < 3 + n && kept < n; i++) {
        double *v = row[kept], size = 0;
        for (int j = 0; j < n; j++) {
            v[j] = i < 3 ? jacobian[i * n + j] * range_of(s, j) : j == i - 3;
            size += v[j] * v[j];
        }
        const double left = take_out(n, kept, row, v);
        if (left > no_direction * sqrt(size)) {
            for (int j = 0; j < n; j++) {
                v[j] /= left;
            }
            kept++;
            rank += i < 3;
        }
    }
    for (int k = rank; k < kept; k++) {
        for (int j = 0; j < n; j++) {
            direction[k - rank][j] = row[k][j] * range_of(s, j);
        }
    }
    return kept - rank;
}
