// reach/scope.h
// A scope: what enters along a fixed line, turns about it and bends. Its joints are
//   q = (insertion [m], turn about the line [rad], then one per tendon: tension [N];
//        of a constant-curvature scope: its bend [rad])
// and its body is the straight shaft on the line, then the tip:
//   g(s) = E Rz(q[1]) Tz(q[0]) h(s; q[2]...), s in [0, length], with E the entry's frame, z along
//   the line; the shaft is s < 0, down to the entry at s = -q[0]          docs/theory.md (10.1)
// The line does not move and no loads act that are fixed in the world, so h depends on the bending
// joints only, insertion and turn are closed form.
#pragma once

#include "base/se3.h"
#include "base/status.h"
#include "rodsolver/rod.h"

#include <stdbool.h>

enum {
    SCOPE_INSERTION,
    SCOPE_TURN,
    SCOPE_BEND, // the first of the bending joints
    SCOPE_TENDONS = 8,
    SCOPE_JOINTS = SCOPE_BEND + SCOPE_TENDONS,
    SCOPE_NAME = 64
};

typedef struct scope {
    char name[SCOPE_NAME];
    const rod *rod; // kept by reference; NULL: constant curvature
    double length;  // of the tip [m]
    double radius;  // of shaft and tip [m]
    int njoint;     // 3 for constant curvature, 2 + tendons not held for a rod
    double low[SCOPE_JOINTS], high[SCOPE_JOINTS]; // joint limits
    // tendons whose tension nothing changes are no joints: the bending joints are the others, in
    // their order
    bool held[SCOPE_TENDONS];
    double held_at[SCOPE_TENDONS]; // [N]
} scope;

// Takes the tendons whose limits are one tension for held ones, but for one where all are: with one
// bending joint left every pose is found. The scope's joints are all its tendons.
void scope_hold(scope *s);

// The tendon that bending joint `joint` pulls.
int scope_tendon(const scope *s, int joint);

// The tensions of all tendons.
void scope_tensions(const scope *s, const double *q, double tension[SCOPE_TENDONS]);

// ERR_INPUT with the joint: limits that are no range or not finite, tensions under 0, a bend of
// more than a full circle, no length, a radius under 0, a rod of another number of tendons or with
// loads.
status scope_check(const scope *s);

// One per thread.
typedef struct scope_state scope_state;
status scope_state_make(const scope *s, const pose *entry, scope_state **out);
void scope_state_free(scope_state *state);
const scope *scope_of(const scope_state *state);
pose scope_entry(const scope_state *state);

// Bends the tip: joints 2 on. From rest, so that one q has one answer to the last bit; free where
// they are those of the last call. ERR_NUMERIC where the rod has no equilibrium there.
status scope_bend(scope_state *state, const double *q);

// --- after scope_bend with the same bending joints

// The tip's end as the base of the tip sees it, and its derivatives by the bending joints [njoint -
// 2] (NULL: not wanted).
status scope_bent_tip(scope_state *state, vec3 *tip, vec3 *derivative);

// The same at arclength s in [0, length].
status scope_bent_point(scope_state *state, double s, vec3 *point, vec3 *derivative);

// The tip's end, and its derivatives by all joints as motions of the point in the world [m per unit
// of the joint] (jacobian [3][njoint], may be NULL).
status scope_tip(scope_state *state, const double *q, vec3 *tip, double *jacobian);

// E Rz(q[1]) Tz(q[0]): the frame of the tip's base.
pose scope_base(const scope_state *state, const double *q);

// The centreline's point at s of the tip (s < 0: on the shaft).
vec3 scope_point(const scope_state *state, const double *q, double s);

// Between two points of the body lies at most this times their difference of s: at least
// max |dp/ds| (over the rod's stations).
double scope_stretch(const scope_state *state);

// --- joints

bool scope_within(const scope *s, const double *q); // every joint in its limits
void scope_clip(const scope *s, double *q);
// "insertion", "turn", "bend", or the tendon's number: "tension 1"
const char *scope_joint_name(const scope *s, int joint, char words[SCOPE_NAME]);
