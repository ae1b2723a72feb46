// app/strained_room.h
// The room of a scope of several tendons whose materials' strains are limited: a pose that strains
// one of them further has less than none.                              docs/theory.md (10.9)
#pragma once

#include "app/reach_scopes.h"
#include "reach/scope_room.h"

typedef struct strained_room {
    scope_room *room;
    const reach_strain_probe *strains;
    double over;                  // how far past its limit a material is, at these tensions:
    double tension[SCOPE_JOINTS]; // as the joints have them
    bool known;
} strained_room;

// All must outlive the probe.
room_probe strained_room_probe(const reach_strain_probe *strains, scope_room *room,
                               strained_room *out);
