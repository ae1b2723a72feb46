// reach/inverse_inside.h
// What the parts of the inverse share.
#pragma once

#include "reach/bend_grid.h"
#include "reach/bend_sweep.h"
#include "reach/inverse.h"

struct inverse {
    const scope *scope;
    bend_sweep sweep; // one bending joint
    bend_grid grid;   // more
};

// A target as the entry's frame sees it, about the line.
typedef struct cylinder_point {
    double rho, angle, z;
} cylinder_point;

cylinder_point cylinder_of(const scope_state *state, vec3 target);

// Insertion and turn, in their limits, that bring a bent tip nearest to the target; returns how
// near [m].
double inverse_on_line(const scope *s, cylinder_point target, vec3 bent, double *q);

// Bends, and says how far the tip is from the target. ERR_NUMERIC as scope_bend.
status inverse_miss(scope_state *state, vec3 target, inverse_pose *pose);

// Keeps a pose that is none of those kept; and the nearest.
void inverse_keep(const scope *s, const inverse_pose *pose, inverse_answer *out);

// inverse_line.c: one bending joint
status inverse_line(const inverse *inv, scope_state *state, vec3 target, inverse_answer *out);

// inverse_fit.c: from here, in the limits; more than one step never makes it worse
status inverse_fit(scope_state *state, vec3 target, inverse_pose *pose);
// inverse_many.c: more than one bending joint
status inverse_many(const inverse *inv, scope_state *state, vec3 target, int want,
                    inverse_answer *out);
