// rodsolver/rod_plan.h
// A quadrature plan: all that a solve needs at the stations of its panels, computed before any
// tension or load is known. Panels come in pairs of equal length; edges of law_along's panels,
// tendon ends, kinks, point loads and ends of line loads are edges of pairs, so that everything is
// smooth inside a pair. Three Gauss stations per panel, in order of s.
#pragma once

#include "rodsolver/lie_step.h"
#include "rodsolver/local_problem.h"
#include "rodsolver/rod.h"

enum { PAIR_STATIONS = 2 * GAUSS_STATIONS, ROD_PROBES = 4, ROD_MAX_PLANS = 20 };

// What the secular equation of one tendon needs, structure of arrays: row after row of [nstation].
// All rows are padded for lanes.h.
enum { ROW_M = 0, ROW_B = 3, ROW_G = 6, SECULAR_ROWS = 24 };

typedef struct plan_tendon {
    int nstation;        // stations before the tendon's end: the first ones
    tendon_place *place; // [nstation], seen from the frame in which the rod is solved
    double *place_row;   // [4][nstation] the same as rows: x, y, dx, dy
    double *row;         // [SECULAR_ROWS][nstation]
    double critical;     // smallest tension at which the tendon alone eats its own length [N] ...
    double critical_at;  // ... and where [m]
} plan_tendon;

// A load per reference arclength at one station, at factor 1.
typedef struct line_station {
    vec3 force, moment; // [N/m, N], in the world or in the frame of the solve, as the load says
    double x, y;        // where the force acts, seen from the frame of the solve [m]
} line_station;

typedef struct plan {
    int npair, nstation;      // nstation = 6 npair
    double *pair_edge;        // [npair][2] [m]
    double *s;                // [nstation] [m]
    mat6 *K;                  // [nstation] in the frame of the solve
    double *K_row;            // [21][nstation] its lower triangle, row by row
    double *rest;             // [6][nstation] xi* in that frame
    centre_frame *frame;      // [nstation], FRAME_NC only
    double *turn;             // [4][nstation] cos phi, sin phi, p_x, p_y of it, FRAME_NC only
    centre_frame *node_frame; // [2 npair + 1] at the panels' ends, FRAME_NC only
    plan_tendon *tendon;      // [ntendon]
    line_station **line;      // [nline_load + gravity] [nstation], zero outside the load's stretch
    int *point_panel; // [npoint_load] the panel (of 2 npair) at whose right end the load acts;
                      // -1: on the base itself
    bool uniform;     // nothing varies inside any pair: one station and one exponential each
                      // would do for tensions alone
} plan;

struct rod {
    const law_along *law;
    rod_options options;
    double length; // [m]
    rest_shape rest;
    double gravity[3];
    int ntendon, npoint_load, nline_load; // gravity is a line load more where it is not zero
    bool has_gravity;
    tendon_spec *spec;       // [ntendon], with .end > 0
    spline *path;            // [ntendon] of their tables, see tendon_table.h
    point_load *point_loads; // [npoint_load], with .s <= length
    line_load *line_loads;   // [nline_load], with .to > 0
    bool *acts;              // [rod_load_count] not zero everywhere
    int nbreak;
    double *breaks; // [nbreak] edges of smooth stretches, from 0 to length
    pose base, tip; // of the solve's frame in the geometric frame, at both ends: T(0), T(L)
    double pair_weight[GAUSS_STATIONS][PAIR_STATIONS]; // pair's stations -> Gauss points of one
                                                       // panel of twice the length

    int nplan;
    plan plans[ROD_MAX_PLANS];  // from coarse to fine
    plan half;                  // where the number of panels is given: half of them
    int first_plan[ROD_PROBES]; // the plan to begin with, by the share of the critical tension
    double doubt; // factor >= 1 on every estimate of the chain, from a comparison of plans
};

typedef struct equilibrium equilibrium; // rodsolver/equilibrium.h

struct rod_state {
    const rod *rod;
    const plan *solved; // NULL: at rest
    double *tension;    // [ntendon] at the base
    int *active;        // [nactive] tendons that pull
    int nactive;
    double *xi;               // [6][nstation] in the solve's frame
    pose *pair_pose;          // [npair + 1] in the solve's frame, from its base
    pose base;                // of the rod in the world
    const plan *warm;         // whose answer `xi` still holds; NULL: none
    int *pulling;             // [ntendon] room: the tendons that pull on a stretch
    lane_tendon *lane_tendon; // [ntendon] room
    local_problem local;      // room for ntendon tendons
    equilibrium *loaded;      // rods under load; made with the state
    bool by_load;             // the last answer is one of `loaded` ...
    bool at_limit;            // ... at a limit point: to be looked at, but nothing starts from it
};

// Shares of the critical tension at which rod_make tries its plans.
extern const double rod_probe_share[ROD_PROBES];

// Stations for about `npanel` panels over the rod, at least two in every smooth stretch. r->plans
// is not touched.
status plan_make(const struct rod *r, int npanel, plan *out);
void plan_free(plan *p, const struct rod *r);

// Loads at the stations: line, point_panel and node_frame.
status plan_fill_loads(const struct rod *r, plan *p);

// Tendons, loads and breaks of the spec, checked and copied.
status rod_copy_spec(struct rod *r, const rod_spec *spec);

// r->breaks: edges of the law's panels, ends of tendons and loads, kinks of whatever varies along
// the rod, and what the spec says.
status rod_find_breaks(struct rod *r, const rod_spec *spec);

// Room for an answer on any of the rod's plans; no equilibrium.
status state_take(const struct rod *r, rod_state *out);
void state_give_back(rod_state *state);

// A plan behind the others.
status plan_add(struct rod *r, int npanel);

// As many plans as r->options.tolerance needs, first_plan and doubt.
status plans_choose(struct rod *r);

// The strain at a station of xi [6][n] or the like.
vec6 station_gather(const double *rows, int n, int i);

// The pair of panels in which s lies.
int plan_pair_at(const plan *p, double s);

// The pose of the geometric centre in the world at arclength s of the last answer.
pose rod_pose_at(const rod_state *state, double s);

// T as a pose: the stiffness-centre frame seen from the geometric one.
pose centre_frame_pose(const centre_frame *f);

// K and xi* at s, in the solve's frame or the geometric centre's; frame is NULL for the latter.
void station_law(const struct rod *r, double s, const centre_frame *frame, mat6 *K, vec6 *rest);

// Solves on one plan under tensions alone (state->tension, active); out->relative_error is the
// estimate, whatever it is.
status solve_on_plan(rod_state *state, const plan *p, rod_solution *out);

// rod_solve for the tip, its error and the iterations alone.
status rod_solve_tip(rod_state *state, const rod_request *request, rod_solution *out);
