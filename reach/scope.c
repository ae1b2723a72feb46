// reach/scope.c
#include "reach/scope.h"

#include "base/memory.h"
#include "reach/arc.h"

#include <stdio.h>
#include <string.h>

struct scope_state {
    const scope *scope;
    pose entry;
    rod_state *rod;             // NULL: constant curvature
    bool bent;                  // what follows holds
    double bend[SCOPE_TENDONS]; // the bending joints
    double stretch;             // at least max |dp/ds|
};

static int nbend(const scope *s)
{
    return s->njoint - SCOPE_BEND;
}

// --- tendons that are no joints

int scope_tendon(const scope *s, int joint)
{
    int tendon = 0;
    for (int free = joint - SCOPE_BEND; tendon < SCOPE_TENDONS - 1; tendon++) {
        if (!s->held[tendon] && free-- == 0) {
            break;
        }
    }
    return tendon;
}

void scope_tensions(const scope *s, const double *q, double tension[SCOPE_TENDONS])
{
    memcpy(tension, s->held_at, sizeof s->held_at);
    for (int j = SCOPE_BEND; j < s->njoint; j++) {
        tension[scope_tendon(s, j)] = q[j];
    }
}

void scope_hold(scope *s)
{
    int n = 0;
    for (int i = 0; i < nbend(s); i++) {
        const double low = s->low[SCOPE_BEND + i], high = s->high[SCOPE_BEND + i];
        s->held[i] = low == high && (n > 0 || i + 1 < nbend(s));
        if (s->held[i]) {
            s->held_at[i] = low;
        } else {
            s->low[SCOPE_BEND + n] = low;
            s->high[SCOPE_BEND + n++] = high;
        }
    }
    s->njoint = SCOPE_BEND + n;
}

// --- what is a scope

// More than a full circle crosses itself.
static const double most_bend = 6.283185307179586;
// A shaft that turns farther is meant in other units.
static const double most_turn = 1000;

const char *scope_joint_name(const scope *s, int joint, char words[SCOPE_NAME])
{
    if (joint == SCOPE_INSERTION || joint == SCOPE_TURN) {
        return joint == SCOPE_TURN ? "turn" : "insertion";
    }
    if (!s->rod) {
        return "bend";
    }
    (void)snprintf(words, SCOPE_NAME, "tension %d", scope_tendon(s, joint) + 1);
    return words;
}

static status check_joint(const scope *s, int i)
{
    char words[SCOPE_NAME];
    const char *joint = scope_joint_name(s, i, words);
    const double low = s->low[i], high = s->high[i];
    if (!isfinite(low) || !isfinite(high) || low > high) {
        return status_fail(ERR_INPUT, "scope %s: limits of %s: %g to %g is no range", s->name,
                           joint, low, high);
    }
    if (i == SCOPE_TURN && fmax(-low, high) > most_turn) {
        return status_fail(ERR_INPUT, "scope %s: a turn of %g rad, at most %g", s->name,
                           fmax(-low, high), most_turn);
    }
    if (i >= SCOPE_BEND && s->rod && low < 0) {
        return status_fail(ERR_INPUT, "scope %s: %s: a tendon cannot push (%g N)", s->name, joint,
                           low);
    }
    if (i >= SCOPE_BEND && !s->rod && fmax(-low, high) > most_bend) {
        return status_fail(ERR_INPUT, "scope %s: a tip bent by more than a full circle", s->name);
    }
    return OK;
}

status scope_check(const scope *s)
{
    status st = OK;
    if (!(s->length > 0) || !isfinite(s->length) || !(s->radius >= 0) || !isfinite(s->radius)) {
        return status_fail(ERR_INPUT, "scope %s: length %g m and radius %g m", s->name, s->length,
                           s->radius);
    }
    if (s->njoint <= SCOPE_BEND || s->njoint > SCOPE_JOINTS || (!s->rod && nbend(s) != 1)) {
        return status_fail(ERR_INPUT, "scope %s: %d bending joints, of %d at most", s->name,
                           nbend(s), s->rod ? SCOPE_TENDONS : 1);
    }
    if (s->rod && rod_load_count(s->rod) > 0) {
        return status_fail(ERR_INPUT,
                           "scope %s: its rod bears loads; a scope's shape may depend on its "
                           "tendons only",
                           s->name);
    }
    for (int i = 0; i < s->njoint; i++) {
        TRY(check_joint(s, i));
    }

done:
    return st;
}

bool scope_within(const scope *s, const double *q)
{
    for (int i = 0; i < s->njoint; i++) {
        if (!(q[i] >= s->low[i] && q[i] <= s->high[i])) {
            return false;
        }
    }
    return true;
}

void scope_clip(const scope *s, double *q)
{
    for (int i = 0; i < s->njoint; i++) {
        q[i] = fmin(fmax(q[i], s->low[i]), s->high[i]);
    }
}

// --- a state of it

status scope_state_make(const scope *s, const pose *entry, scope_state **out)
{
    status st = OK;
    scope_state *state = NULL;
    TRY(scope_check(s));
    TRY(TAKE(state, 1));
    state->scope = s;
    state->entry = *entry;
    if (s->rod) {
        TRY(rod_state_make(s->rod, &state->rod));
    }
    *out = state;
    state = NULL;

done:
    scope_state_free(state);
    return st;
}

void scope_state_free(scope_state *state)
{
    if (state) {
        rod_state_free(state->rod);
        free(state);
    }
}

const scope *scope_of(const scope_state *state)
{
    return state->scope;
}

pose scope_entry(const scope_state *state)
{
    return state->entry;
}

status scope_bend(scope_state *state, const double *q)
{
    status st = OK;
    const double *bend = q + SCOPE_BEND;
    const size_t bytes = (size_t)nbend(state->scope) * sizeof *bend;
    if (state->bent && memcmp(bend, state->bend, bytes) == 0) {
        return OK;
    }
    state->bent = false;
    state->stretch = 1;
    if (state->rod) {
        rod_solution out = {0};
        double tension[SCOPE_TENDONS];
        scope_tensions(state->scope, q, tension);
        TRY(rod_solve(state->rod, &(rod_request){.tension = tension, .cold = true}, &out));
        // at rest v = (0, 0, 1)
        const double *e = out.max_strain.a;
        state->stretch = sqrt(e[0] * e[0] + e[1] * e[1] + (1 + e[2]) * (1 + e[2]));
    }
    memcpy(state->bend, bend, bytes);
    state->bent = true;

done:
    return st;
}

double scope_stretch(const scope_state *state)
{
    return state->stretch;
}

// --- points

status scope_bent_point(scope_state *state, double s, vec3 *point, vec3 *derivative)
{
    status st = OK;
    const double length = state->scope->length;
    pose g;
    vec6 twist[SCOPE_TENDONS];
    if (!state->rod) {
        *point = arc_point(length, state->bend[0], s);
        if (derivative) {
            *derivative = arc_derivative(length, state->bend[0], s);
        }
        return OK;
    }
    TRY(rod_pose(state->rod, s, &g));
    *point = g.p;
    if (derivative) {
        TRY(rod_derive(state->rod, s, &(rod_derivatives){.tension = twist}));
        for (int i = 0; i < nbend(state->scope); i++) {
            const int tendon = scope_tendon(state->scope, SCOPE_BEND + i);
            derivative[i] = mat3_mul_vec(g.R, vec6_linear(twist[tendon]));
        }
    }

done:
    return st;
}

status scope_bent_tip(scope_state *state, vec3 *tip, vec3 *derivative)
{
    return scope_bent_point(state, state->scope->length, tip, derivative);
}

pose scope_base(const scope_state *state, const double *q)
{
    const pose on_line = {mat3_rot_z(q[SCOPE_TURN]), {{0, 0, q[SCOPE_INSERTION]}}};
    return pose_mul(state->entry, on_line);
}

status scope_tip(scope_state *state, const double *q, vec3 *tip, double *jacobian)
{
    status st = OK;
    const int n = state->scope->njoint;
    const pose base = scope_base(state, q);
    vec3 h, column[SCOPE_JOINTS];
    TRY(scope_bent_tip(state, &h, jacobian ? &column[SCOPE_BEND] : NULL));
    *tip = vec3_add(base.p, mat3_mul_vec(base.R, h));
    if (jacobian) {
        column[SCOPE_INSERTION] = (vec3){{0, 0, 1}};
        column[SCOPE_TURN] = vec3_cross(column[SCOPE_INSERTION], h);
        for (int j = 0; j < n; j++) {
            const vec3 world = mat3_mul_vec(base.R, column[j]);
            for (int i = 0; i < 3; i++) {
                jacobian[i * n + j] = world.a[i];
            }
        }
    }

done:
    return st;
}

vec3 scope_point(const scope_state *state, const double *q, double s)
{
    const pose base = scope_base(state, q);
    vec3 h = {{0, 0, s}};
    pose g;
    if (s > 0 && state->rod && rod_pose(state->rod, s, &g) == OK) {
        h = g.p;
    } else if (s > 0 && !state->rod) {
        h = arc_point(state->scope->length, state->bend[0], s);
    }
    return vec3_add(base.p, mat3_mul_vec(base.R, h));
}
