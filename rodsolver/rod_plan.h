// rodsolver/rod_plan.h
// A quadrature plan: all that a solve needs at the stations of its panels, computed before any
// tension is known. Panels come in pairs of equal length; edges of law_along's panels and tendon
// ends are edges of pairs, so that everything is smooth inside a pair. Three Gauss stations per
// panel, in order of s.
#pragma once

#include "rodsolver/lie_step.h"
#include "rodsolver/local_problem.h"

enum { PAIR_STATIONS = 2 * GAUSS_STATIONS, ROD_PROBES = 4, ROD_MAX_PLANS = 20 };

// What the secular equation of one tendon needs, structure of arrays: row after row of [nstation].
enum { ROW_M = 0, ROW_B = 3, ROW_G = 6, SECULAR_ROWS = 24 };

typedef struct plan_tendon {
    int nstation;        // stations before the tendon's end: the first ones
    tendon_place *place; // [nstation], seen from the frame in which the rod is solved
    double *row;         // [SECULAR_ROWS][nstation]
    double critical;     // smallest tension at which the tendon alone eats its own length [N] ...
    double critical_at;  // ... and where [m]
} plan_tendon;

typedef struct plan {
    int npair, nstation; // nstation = 6 npair
    double *pair_edge;   // [npair][2] [m]
    double *s;           // [nstation] [m]
    mat6 *K;             // [nstation] in the frame of the solve
    double *rest;        // [6][nstation] xi* in that frame
    centre_frame *frame; // [nstation], FRAME_NC only
    plan_tendon *tendon; // [ntendon]
} plan;

struct rod {
    const law_along *law;
    rod_options options;
    double length; // [m]
    int ntendon;
    tendon_spec *spec; // [ntendon], with .end > 0
    int nbreak;
    double *breaks; // [nbreak] edges of smooth stretches, from 0 to length
    pose base, tip; // of the solve's frame in the geometric frame, at both ends: T(0), T(L)
    double pair_weight[GAUSS_STATIONS][PAIR_STATIONS]; // pair's stations -> Gauss points of one
                                                       // panel of twice the length

    int nplan;
    plan plans[ROD_MAX_PLANS];  // from coarse to fine
    int first_plan[ROD_PROBES]; // the plan to begin with, by the share of the critical tension

    double doubt; // factor >= 1 on every estimate, from a comparison of plans

    // the last solution
    const plan *solved; // NULL: none
    double tension[ROD_MAX_TENDONS];
    int active[ROD_MAX_TENDONS]; // tendons that pull
    int nactive;
    double *xi;      // [6][nstation]
    pose *pair_pose; // [npair + 1] in the solve's frame, from its base
};

// Shares of the critical tension at which rod_make tries its plans.
extern const double rod_probe_share[ROD_PROBES];

// Stations for about `npanel` panels over the rod, at least two in every smooth stretch. r->plans
// is not touched.
status plan_make(const struct rod *r, int npanel, plan *out);
void plan_free(plan *p, int ntendon);

// A plan behind the others, and room for its solution: plans are added from coarse to fine.
status plan_add(struct rod *r, int npanel);

// As many plans as r->options.tolerance needs, first_plan and doubt.
status plans_choose(struct rod *r);

// T as a pose: the stiffness-centre frame seen from the geometric one.
pose centre_frame_pose(const centre_frame *f);

// K and xi* at s, in the solve's frame or the geometric centre's; frame is NULL for the latter.
void station_law(const struct rod *r, double s, const centre_frame *frame, mat6 *K, vec6 *rest);

// Solves on one plan; out->relative_error is the estimate, whatever it is.
status solve_on_plan(struct rod *r, const plan *p, rod_solution *out);
