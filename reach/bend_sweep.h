// reach/bend_sweep.h
// How a tip moves as its one bending joint goes through its range: nodes as close as cubics between
// them need to be right.                                               docs/theory.md (10.2)
#pragma once

#include "reach/scope.h"

enum { SWEEP_SAMPLES = 16 }; // of the body, the tip last

typedef struct bend_node {
    double u;        // the joint
    vec3 tip, slope; // of the tip's end by u, as the tip's base sees it
    double farthest; // no point of the tip is farther from the line [m]
    double moved; // no point of the tip moves farther between two nodes than their difference [m]
    double tip_moved; // the same of its end
} bend_node;

typedef struct bend_sweep {
    int nnode; // at least 2
    bend_node *node;
    double error; // of the cubics at the middles of their nodes, largest [m]
} bend_sweep;

// ERR_NUMERIC where the scope's rod has no equilibrium within the joint's limits, or where the
// nodes would have to be closer than 1/4096 of the range.
status bend_sweep_make(scope_state *state, bend_sweep *out);
void bend_sweep_free(bend_sweep *w);

// The node before u, at most nnode - 2.
int bend_sweep_cell(const bend_sweep *w, double u);

// Between nodes: tip by the cubic, the rest linear.
bend_node bend_sweep_at(const bend_sweep *w, double u);

// Every u where the cubics' tip is `rho` away from the line, ascending; returns how many.
int bend_sweep_roots(const bend_sweep *w, double rho, int most, double *u);
