// rodsolver/stations.h
#pragma once

#include "rodsolver/rod_plan.h"

// state->xi under state->tension, docs/theory.md (4.3); adds the Newton steps of all stations.
status stations_solve(rod_state *state, const plan *p, int *steps);

// max_strain, energy and residual of state->xi.
void stations_check(const rod_state *state, const plan *p, rod_solution *out);

// docs/theory.md (4.9): [ntendon] [m]
void stations_lengths(const rod_state *state, const plan *p, double *length);
