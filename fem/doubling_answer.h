// fem/doubling_answer.h
// From the parts' cuts to a way_run. docs/theory.md (5.12)
#pragma once

#include "fem/doubling_tree.h"
#include "fem/level_fit.h"
#include "fem/way.h"

// A prism in equal slabs, and what loads and measures it. Forces [..][nplane][3] are along a, b, z.
typedef struct doubling {
    const segment_problem *problem;
    const way_wants *wants;
    cut cut;
    slab slab;
    int doublings, grid, ncolumn;
    double begin, turn_rate; // s of the base [m]; [rad/m]
    double *tip_force;       // [ncolumn]
    double *base_force;      // [ncolumn] that a base free to contract answers with
    double *fit;             // [6] E-weighted motion about the section's origin, in its axes
} doubling;

// Room for the answer; its heights.
status doubling_answer_take(const doubling *d, way_run *run);

// Adds what one part has to say.
status doubling_answer_add(const doubling *d, const doubling_tree *t, double *cell_energy,
                           way_run *run);

// Turns all into the base's axes, puts the base's mean motion back, and makes the window's energy
// from those of the cells [2^grid][6][6]. ERR_NUMERIC where rounding has the better of it.
status doubling_answer_finish(const doubling *d, const double *cell_energy, way_run *run);

// --- fem/doubling_fields.c

// Adds one part's displacements at the body's levels, along a, b, z there. From the columns of
// `active` the cells' ends are given.
status doubling_fields_add(const doubling *d, const doubling_tree *t, const int *active,
                           slab_list *cells, way_run *run);

// One column into the base's axes; takes the base's mean motion (in its plane) away.
void doubling_fields_finish(const doubling *d, int column, vec6 mean, way_run *run);
