// rodsolver/rod.h
// The shape of a rod under its tendons and any load, docs/theory.md section 4. Needs base only;
// starts no library, prints nothing. For control loops and optimisers:
//
//   rod_make        once: routing, K, loads and quadrature at every station; then never changed, so
//                   that any number of threads may share it
//   rod_state_make  once per thread: the last answer and all room that a solve needs
//   rod_solve       many times, from the last answer or from rest; allocates nothing
//   rod_shape, rod_strain_at, rod_wrench_at, rod_derivatives  what else the last answer tells
//
// SI throughout. Wrenches are (force, moment), twists and strains (v, w): linear part first.
#pragma once

#include "base/field.h"
#include "base/law_along.h"
#include "base/mark.h"
#include "base/se3.h"
#include "base/status.h"

#include <stdbool.h>
#include <stddef.h>

// --- what the rod is

// A path through given points: an interpolating or, where smooth > 0, a least-squares spline.
typedef struct tendon_table {
    int count;           // 0: no table
    const double *point; // [count][3] rows (s, x, y) [m], s ascending; the caller's, kept
    double smooth;       // rms distance from the points that the fit may leave [m]; 0: through them
} tendon_table;

typedef struct tendon_spec {
    mark at;
    const char *name;    // owned by the caller; NULL where not given
    field radius, angle; // polar position in the section [m, rad], ...
    field x, y;          // ... Cartesian, added to it [m] ...
    tendon_table table;  // ... and a table, added too
    double end;          // arclength where it is anchored [m]; 0: the tip
    double friction;     // Coulomb coefficient along the path [-]
    double EA;           // of the tendon itself [N]; 0: it does not stretch
    double outside;      // its length between the actuator and the base [m], stretching under the
                         // full tension
} tendon_spec;

// SPACE: directions fixed in the frame of the world (dead); BODY: turning with the section
// (follower).
typedef enum load_frame { LOAD_SPACE, LOAD_BODY } load_frame;

typedef struct point_load {
    mark at;
    const char *name;           // NULL where not given
    double s;                   // where [m]; beyond the length: the tip
    int frame;                  // load_frame
    double force[3], moment[3]; // [N, N m]
    double place[2];            // x, y in the section where the force acts [m]
} point_load;

typedef struct line_load {
    mark at;
    const char *name;
    double from, to;           // arclengths [m]; to 0: the tip
    int frame;                 // load_frame
    field force[3], moment[3]; // per reference arclength [N/m, N]
    field place[2];            // x, y in the section where the force acts [m]
} line_load;

// xi* = (shear_x, shear_y, stretch, curvature_x, curvature_y, twist); all zero but stretch = 1: a
// straight rod. Jumps lie on edges of the law's panels or in `breaks`.
typedef struct rest_shape {
    mark at;
    field curvature_x, curvature_y, twist; // of the geometric centreline [1/m]
} rest_shape;

typedef struct rod_spec {
    const law_along *law; // K(s); kept by reference, must outlive the rod, as names and expressions
                          // must
    rest_shape rest;
    int ntendon, npoint_load, nline_load, nbreak;
    const tendon_spec *tendons;
    const point_load *point_loads;
    const line_load *line_loads;
    const double *breaks; // [nbreak] arclengths where a field jumps [m], any order
    double gravity[3];    // acceleration in the frame of the world [m/s^2], on the law's masses
} rod_spec;

typedef enum rod_frame { FRAME_GC, FRAME_NC } rod_frame;

// The rounding of the chain of panels: no estimate falls reliably below this.
#define ROD_MIN_TOLERANCE 1e-13

typedef struct rod_options {
    int frame; // rod_frame; FRAME_NC only where neither the stiffness centre nor its axes jump
    double tolerance; // |p - p_exact| / L at the tip
    int npanel; // integration panels, rounded up to pairs in every smooth stretch; 0: as many as
                // the tolerance needs, chosen anew for every solve among plans that rod_make
                // prepares
} rod_options;

typedef struct rod rod;             // defined in rodsolver/rod_plan.h
typedef struct rod_state rod_state; // defined in rodsolver/rod_plan.h

status rod_make(const rod_spec *spec, const rod_options *options, rod **out);
void rod_free(rod *r);

// At rest. The rod must outlive its states.
status rod_state_make(const rod *r, rod_state **out);
void rod_state_free(rod_state *state);

// The number of loads that rod_request.load scales: point loads, line loads, then gravity where
// it is not zero.
int rod_load_count(const rod *r);

// The tension at which this tendon alone eats its own length somewhere, docs/theory.md (4.5), and
// where; s may be NULL.
double rod_critical_tension(const rod *r, int tendon, double *s);

// Bytes of the coarsest plan with at least nstation stations, or of the finest.
size_t rod_plan_bytes(const rod *r, int nstation);

// --- solving

typedef struct rod_request {
    const double *tension; // [ntendon] at the base [N], >= 0; NULL: none
    const double *pull;    // [ntendon] length drawn out of the base [m]; NAN: this tendon's tension
                           // is given instead; NULL: all tensions are given
    const double *load;    // [rod_load_count] factors of the rod's loads; NULL: 1 each
    vec6 tip_space;        // wrench on the tip's centre, directions fixed in the world
    vec6 tip_body;         // wrench on the tip's centre, turning with the tip
    const pose *base;      // NULL: the identity
    bool cold;      // from rest, not from the last answer: the same bits for the same request
    bool past;      // follow the equilibria past limit points (arclength)
    bool stability; // the smallest eigenvalue and the work too
} rod_request;

typedef enum critical_kind {
    CRITICAL_LIMIT,       // the load cannot grow on: the rod snaps
    CRITICAL_BIFURCATION, // another equilibrium branches off, or stability is lost otherwise
} critical_kind;

typedef struct rod_critical {
    int kind;        // critical_kind
    double fraction; // of the way from the start (rest, or the last request) to this request
    int negative;    // negative directions of the second variation behind it; -1: no potential
} rod_critical;

enum { ROD_MAX_CRITICAL = 16 };

typedef struct rod_solution {
    pose tip;              // of the geometric centre, in the world
    double *tendon_length; // [ntendon] inside the body [m], the caller's, filled; may be NULL
    double *tension;       // [ntendon] at the base [N], as given or found (0: slack), the caller's;
                           // may be NULL
    int iterations;        // Newton steps: over all stations and plans tried where nothing but
                           // tensions act, of the whole rod otherwise
    double relative_error; // of the tip, |p - p_exact| / L: an estimate
    vec6 max_strain;       // largest size of each component of xi - xi* over the stations
    double fraction;       // of the request that was reached: 1, or less at a limit point
    int stable;            // 1, 0, or -1: not known (follower loads, friction: no potential)
    double eigenvalue;     // smallest of the second variation over the elastic energy's: 1 is the
                           // rod at rest, 0 critical; NAN: not asked for, or no potential
    bool limited;          // a limit point stands in the way, and this is the answer there
    int ncritical;         // met on the way; of more than ROD_MAX_CRITICAL the first ones, and the
                           // limit point that stands in the way
    rod_critical critical[ROD_MAX_CRITICAL];
    double energy;   // stored by the strains [J]
    double work;     // of dead loads and tendons on the way from rest, by the balance of
                     // energies [J]; under loads NAN: not asked for, or no potential
    double residual; // largest misfit of the local balance, in strain units over the largest
                     // strain
} rod_solution;

// The equilibrium reached by continuation, from the last answer or from rest.
//   ERR_INPUT    a negative tension, a number that is not finite, a base whose R is no rotation
//   ERR_NUMERIC  a tendon has eaten its own length; or a limit point stands in the way
//                (out->limited, out->fraction, out->critical tell; the state is that of the limit
//                point); or no convergence; or the tolerance cannot be met
// After a failure other than a limit point the state is at rest. From a limit point nothing is
// derived, and the next solve starts from rest.
status rod_solve(rod_state *state, const rod_request *request, rod_solution *out);

// Panels of the last solution; before one, those that a load near the critical one begins with.
int rod_panel_count(const rod_state *state);

// Tips for n rows of tensions at once, cold, on nthread threads (0: all cores): the bits of
// rod_solve, however many threads; loads and everything else as in `like` (NULL: none). tension
// [n][ntendon], tip [n] (NAN where a row failed), outcome [n] (may be NULL). failed: how many rows
// did. Allocates its states once.
status rod_batch(const rod *r, int nthread, int n, const double *tension, const rod_request *like,
                 pose *tip, status *outcome, int *failed);

// --- after rod_solve

// Poses of the geometric centreline at npoint equally spaced arclengths, ends included [npoint].
status rod_shape(const rod_state *state, int npoint, double *s, pose *out);

// The pose of the geometric centreline at one arclength, clipped to [0, length].
status rod_pose(const rod_state *state, double s, pose *out);

// The strain xi in the frame of the geometric centre at arclength s.
status rod_strain_at(const rod_state *state, double s, vec6 *xi);

// K (xi - xi*): the wrench that the section itself carries, tendons not included, and tensions
// there [ntendon] (0 past a tendon's end; less than at the base by friction); tension may be NULL.
status rod_wrench_at(const rod_state *state, double s, vec6 *wrench, double *tension);

// Derivatives of the pose at arclength s (and of tendon quantities) as body twists: column j is
// (g^-1 dg/dx_j)^vee. Any pointer may be NULL.
typedef struct rod_derivatives {
    vec6 *tension;   // [ntendon] by the tensions; for tendons whose pull is given, 0
    vec6 *pull;      // [ntendon] by the pulled lengths; for slack tendons and given tensions, 0
    vec6 *load;      // [rod_load_count] by the loads' factors
    mat6 *tip_space; // by request.tip_space: the compliance at s to a wrench at the tip
    mat6 *tip_body;  // by request.tip_body
    mat6 *base;      // by the base's body twist: Ad(g(s)^-1 g(0)), loads fixed in space included
    double *length_by_tension; // [ntendon][ntendon] of the tendons' lengths by tensions [m/N]
} rod_derivatives;

status rod_derive(rod_state *state, double s, const rod_derivatives *out);

// By any design parameter: `plus` and `minus` are rods made with the parameter step larger and
// smaller, with the same number of breaks, tendons and loads; npanel and options those of the
// state's rod. The linear solve is exact, only the stations' data are differenced.
status rod_derive_design(rod_state *state, const rod *plus, const rod *minus, double step, double s,
                         vec6 *out);

// The same towards one other rod, made with the parameter larger by `step` (smaller where step <
// 0): off by O(step). Two of them, D(h) and D(-h), or at the end of a parameter's range D(h) and
// D(2 h), leave O(step^2): (D(h) + D(-h)) / 2 and 2 D(h) - D(2 h).
status rod_derive_towards(rod_state *state, const rod *other, double step, double s, vec6 *out);

// The compliance of the straight rod clamped at its base: the linear limit, for `compare`. Wrench
// (F, M) at the tip -> motion (u, phi) of the tip, fixed base axes, by ngauss <= 32 points per
// panel of the law.
//   C = int_0^L P^T K^-1 P ds, P = [I, 0; hat((L - s) e_z), I]     docs/theory.md (4.10)
status rod_linear_compliance(const law_along *law, double length, int ngauss, mat6 *out);

// The same of the part between two arclengths, clamped at the first.
status rod_linear_compliance_between(const law_along *law, double from, double to, int ngauss,
                                     mat6 *out);
