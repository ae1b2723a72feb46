// rodsolver/equilibrium.h
// The rod under loads, pulled lengths or friction, where every station depends on all others.
#pragma once

#include "rodsolver/rod.h"

typedef struct equilibrium equilibrium;

// Room for one state of this rod.
status equilibrium_make(const rod *r, equilibrium **out);
void equilibrium_free(equilibrium *e);

// rod_solve where something acts besides tensions that stay the same along their tendons.
status equilibrium_solve(rod_state *state, const rod_request *request, rod_solution *out);
