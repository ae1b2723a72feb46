// rodsolver/local_problem.h
// One station's own problem: the strain that minimises  1/2 (xi - xi*)^T K (xi - xi*) + sum tau_i
// |d_i(xi)| with d_i = v + w x r_i + r_i'.   docs/theory.md (4.3). Convex, so there is one
// solution; smooth while every |d_i| > 0.
#pragma once

#include "rodsolver/lanes.h"
#include "rodsolver/routing.h"

// d at the strain xi: along the tendon's tangent, its length per reference arclength [-].
vec3 tendon_direction(const tendon_place *r, const vec6 *xi);

// A^T f: the wrench of a force f at the tendon's place, (f, r x f).
vec6 tendon_wrench(const tendon_place *r, vec3 f);

typedef enum local_outcome {
    LOCAL_SOLVED,
    LOCAL_EATEN,  // a tendon's |d| went to zero: no smooth minimum
    LOCAL_FAILED, // no convergence
} local_outcome;

// A tendon that pulls at the station; what follows its place and tension is room for the solve.
typedef struct local_tendon {
    tendon_place place;
    double tension; // > 0 [N]
    vec3 d0;        // d at rest
    double l, kept, step;
    vec3 y;      // d / l
    double size; // |y|
} local_tendon;

typedef struct local_problem {
    const mat6 *K;
    vec6 rest;            // xi*
    int ntendon;          // those that pull here
    local_tendon *tendon; // [ntendon]
} local_problem;

// Newton in the tendons' lengths with a line search on a convex function, from *xi; docs/theory.md
// (4.4). steps counts linear solves and is added to. which: the tendon with the smallest |d|.
local_outcome local_solve(const local_problem *p, vec6 *xi, int *steps, int *which);

// --- eight stations at once

// Rows of numbers, one column per station: the stations at `K`, `rest` and `place` and the seven
// after them.
typedef struct lane_tendon {
    const double *place; // x, y, dx, dy: [4][stride]
    int stride;
    double tension; // > 0 [N]
} lane_tendon;

typedef struct lane_problem {
    const double *K;    // [21][stride] lower triangle, row by row
    const double *rest; // [6][stride] xi*
    int stride, count;  // the first `count` stations matter
    int ntendon;
    const lane_tendon *tendon; // [ntendon]
} lane_problem;

// Newton in the strains, from xi: quadratic wherever no tendon comes near to being eaten. The
// number of steps; bit k of *unsolved says that station k asks for local_solve.
int local_solve_lanes(const lane_problem *p, lanes xi[6], unsigned *unsolved);

// Of given strains: e^T K e, and the misfit g of the balance (4.2) as sum g_c^2 / K_cc.
void local_check_lanes(const lane_problem *p, const lanes xi[6], lanes *energy, lanes *misfit);

// --- one tendon alone

// With d = l t, |t| = 1 the problem is (l I + tau M) t = d_0, M = A K^-1 A^T: in M's own axes one
// scalar equation for l, sum b_j^2 / (l + tau m_j)^2 = 1, docs/theory.md (4.5). All that does not
// depend on tau is made ready per station.
typedef struct secular_station {
    double m[3];    // eigenvalues of M [1/N], ascending not needed
    double b[3];    // d_0 in M's axes
    double G[6][3]; // xi = xi* - tau G y, y_j = b_j / (l + tau m_j)
} secular_station;

// F = K^-1.
void secular_prepare(const mat6 *F, const vec6 *rest, const tendon_place *r, secular_station *out);

// The tension at which this tendon alone eats its own length here: |M^-1 d_0| [N].
double secular_critical(const secular_station *s);

// y (unit vectors) for eight stations at once, of which the first `count` matter. The number of
// Newton steps, or -1 where they do not converge. tau must be below the critical tension of every
// station.
int secular_solve(double tau, int count, const lanes m[3], const lanes b[3], lanes y[3]);
