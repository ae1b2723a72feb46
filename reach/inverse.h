// reach/inverse.h
// Joints that bring a scope's tip to a target.                 docs/theory.md (10.2) to (10.6)
//
// Insertion and turn put the tip anywhere on a cylinder about the entry line, so that the bending
// joints have to bring the tip to the target's distance rho from the line:
//   constant curvature   rho / L = (1 - cos a) / a by its monotone pieces: all solutions
//   one tendon           rho(u) on cubics through a sweep of the rod, all roots: all solutions
//   more tendons         least squares in the joints' limits from starts that a grid over the
//                        bending joints chooses; cells that cannot hold the target are left out
#pragma once

#include "reach/scope.h"

enum { INVERSE_POSES = 32, INVERSE_OUT_OF_REACH = -1, INVERSE_NO_LIMIT = -2 };

// The tip is at the target when it is nearer than this [m].
#define INVERSE_EXACT 1e-7

typedef struct inverse_pose {
    double q[SCOPE_JOINTS];
    double miss; // of the tip from the target, by the scope itself [m]
} inverse_pose;

typedef struct inverse_answer {
    int npose; // within the limits, tip at the target; 0: not reachable. One bending joint: all of
               // them; more: those found, apart from each other, of a whole family
    inverse_pose pose[INVERSE_POSES];
    inverse_pose nearest; // within the limits, the tip as near as it comes
    int limit;  // the joint whose limit keeps `nearest` away; INVERSE_OUT_OF_REACH: none does;
                // INVERSE_NO_LIMIT: reached
    int starts; // searches begun: one per root, or per start of the least squares; 0: the map alone
                // says that no pose is near
} inverse_answer;

// Made once per scope; any number of threads may ask at once, each with its own state.
typedef struct inverse inverse;
status inverse_make(const scope *s, inverse **out);
void inverse_free(inverse *inv);

// How finely the bending joints were looked at: between two neighbouring nodes the tip moves by at
// most this [m].
double inverse_spacing(const inverse *inv);

// `state` of the same scope. `target` in the world. Not reachable is an answer, no failure.
status inverse_solve(const inverse *inv, scope_state *state, vec3 target, inverse_answer *out);

// The same with about `want` poses, at most INVERSE_POSES, of the family that more than one bending
// joint has: from starts all over the grid's cells that may hold the target.
status inverse_family(const inverse *inv, scope_state *state, vec3 target, int want,
                      inverse_answer *out);

// Orthonormal directions in the scaled joints (each by its range) that leave the tip where it is,
// to first order: at most njoint - 3, as rows of motions of q. Returns how many.
int inverse_null_space(const scope *s, const double *jacobian, double (*direction)[SCOPE_JOINTS]);
