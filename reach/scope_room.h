// reach/scope_room.h
// The room that a scope has in a surface: what a search asks for.
#pragma once

#include "reach/clearance.h"
#include "reach/search.h"

typedef struct scope_room {
    const distance_tree *tree;
    double tolerance;  // of the clearance, from above [m]
    double free_entry; // from the entry, this much of the body is not looked at [m]
} scope_room;

// After scope_bend: how much room the body has at q, and where it is least.
void scope_clearance(const scope_room *room, scope_state *state, const double *q, clearance *out);

// `room` is the probe's context and must outlive it.
room_probe scope_room_probe(scope_room *room);
