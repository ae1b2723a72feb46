// rodsolver/local_problem.h
// One station's own problem: the strain that minimises  1/2 (xi - xi*)^T K (xi - xi*) + sum tau_i
// |d_i(xi)| with d_i = v + w x r_i + r_i'.   docs/theory.md (4.3). Convex, so there is one
// solution; smooth while every |d_i| > 0.
#pragma once

#include "rodsolver/routing.h"

// d at the strain xi: along the tendon's tangent, its length per reference arclength [-].
vec3 tendon_direction(const tendon_place *r, const vec6 *xi);

// A^T f: the wrench of a force f at the tendon's place, (f, r x f).
vec6 tendon_wrench(const tendon_place *r, vec3 f);

enum { ROD_MAX_TENDONS = 16 };

typedef enum local_outcome {
    LOCAL_SOLVED,
    LOCAL_EATEN,  // a tendon's |d| went to zero: no smooth minimum
    LOCAL_FAILED, // no convergence
} local_outcome;

typedef struct local_problem {
    const mat6 *K;
    vec6 rest;   // xi*
    int ntendon; // those that pull here
    tendon_place place[ROD_MAX_TENDONS];
    double tension[ROD_MAX_TENDONS]; // > 0 [N]
} local_problem;

// Newton in the tendons' lengths with a line search on a convex function, from *xi; docs/theory.md
// (4.4). steps counts linear solves and is added to. which: the tendon with the smallest |d|.
local_outcome local_solve(const local_problem *p, vec6 *xi, int *steps, int *which);

// One tendon alone: with d = l t, |t| = 1 the problem is (l I + tau M) t = d_0, M = A K^-1 A^T: in
// M's own axes one scalar equation for l, sum b_j^2 / (l + tau m_j)^2 = 1, docs/theory.md (4.5).
// All that does not depend on tau is made ready per station.
typedef struct secular_station {
    double m[3];    // eigenvalues of M [1/N], ascending not needed
    double b[3];    // d_0 in M's axes
    double G[6][3]; // xi = xi* - tau G y, y_j = b_j / (l + tau m_j)
} secular_station;

// ERR_NUMERIC where K is not positive definite.
status secular_prepare(const mat6 *K, const vec6 *rest, const tendon_place *r,
                       secular_station *out);

// The tension at which this tendon alone eats its own length here: |M^-1 d_0| [N].
double secular_critical(const secular_station *s);

enum { SECULAR_LANES = 8 };

// l for SECULAR_LANES stations at once: m, b [3][lanes] in, y out (unit vectors). The number of
// Newton steps, or -1 where they do not converge. tau must be below the critical tension of every
// lane.
int secular_solve(double tau, const double m[3][SECULAR_LANES], const double b[3][SECULAR_LANES],
                  double y[3][SECULAR_LANES]);
