// fem/level_loads.h
// Nodal forces of a segment_problem's columns, level by level, each rank with its own.
// docs/theory.md (5.6), (5.8), (5.11)
#pragma once

#include "fem/level_fit.h"
#include "fem/petsc_door.h"
#include "fem/unknowns.h"

typedef struct level_loads {
    int ncolumn;
    // [ncolumn][to - from][nplane][3] of the levels that the rank holds; whole on the levels whose
    // rows it has. Without the unit wrenches of a rigid cap: those act on the cap's own unknowns.
    double *force;
    // Resultants, about the base's origin, of what the layer's own distributed loads put on the
    // nodes of its upper level: [ncolumn][last_layer - first_layer]
    vec6 *on_top;
    vec6 *on_base; // [ncolumn] of the first layer's on the base's nodes, where it is this rank's
} level_loads;

// (all) Needs the door for the balance of a base that is free to contract.
status level_loads_make(const petsc_door *door, const segment_problem *p, const level_share *s,
                        level_loads *out);
void level_loads_free(level_loads *l);

static inline size_t level_loads_offset(const body *b, const level_share *s, int column, int level)
{
    return ((size_t)column * (size_t)(s->to - s->from) + (size_t)(level - s->from)) * 3 *
           (size_t)b->plane->nnode;
}

// This rank's right-hand sides [ncolumn][last - first][3], zero in held directions.
void level_loads_gather(const level_loads *l, const segment_problem *p, const unknowns *u,
                        double *b);

// --- fem/level_balance.c

// (all) Sideways forces and torque are answered by a traction on the base. (5.8)
status level_loads_balance(const petsc_door *door, const segment_problem *p, const level_share *s,
                           level_loads *loads);

// Adds nodal forces [nplane][3] with the resultant w about the section's origin.
void level_fit_add_wrench(const level_fit *fit, vec6 w, double *force);

// The same wrench with its moment about another point, and a force's about the base's origin.
vec6 wrench_moved(vec6 w, const double from[3], const double to[3]);
vec6 wrench_of_force(const double *force, const double *place);
