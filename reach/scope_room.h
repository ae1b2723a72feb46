// reach/scope_room.h
// The room that a scope has in a surface: what a search asks for.
#pragma once

#include "reach/clearance.h"
#include "reach/search.h"

typedef struct scope_room {
    const distance_tree *tree;
    double tolerance;  // of the clearance, from above [m]
    double free_entry; // a channel about the line leads so far, through tissue if need be [m]
    double shaft_free; // so far along the line a shaft is known to have room, and is not asked
                       // for it again; the tip is; less than free_entry: that [m]
    double leave;      // to be left beside the body, which the channel leaves too: a probe counts
                       // what is more than that [m]
} scope_room;

// Room more than that which the channel leaves about the scope: there a body is off the line by no
// more than this. A scope bends behind it, or so little before it [m]. docs/theory.md (10.14)
#define SCOPE_CHANNEL_PLAY 1e-4

// After scope_bend: how much room the body has at q, and where it is least.
void scope_clearance(const scope_room *room, scope_state *state, const double *q, clearance *out);

// `room` is the probe's context and must outlive it.
room_probe scope_room_probe(scope_room *room);
