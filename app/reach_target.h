// app/reach_target.h
// One scope at one target: the work that is shared out.
#pragma once

#include "app/reach_run.h"
#include "app/strained_room.h"
#include "reach/scope_room.h"
#include "reach/way.h"

typedef struct reach_work {
    const reach_study *how;
    const reach_scope *scope;
    inverse *inverse;
    scope_state *state;
    scope_room room;
    reach_strain_probe *strains; // NULL: no strains are asked for
    strained_room strained;
    room_probe probe; // of the room, and of the strains where they may refuse a pose
    search_options options;
    int first; // target of the first item
} reach_work;

// In place: *out must not move.
status reach_work_make(const reach_study *how, reach_scope *s, reach_work *out);
void reach_work_free(reach_work *w);

// Plain bytes, as a worker hands them over.
typedef struct target_found {
    reach_answer answer; // without what it owns
    int npath;
    double path[WAY_POSES][SCOPE_JOINTS]; // [npath]
} target_found;

// How much of a target_found there is: the path only where ways in are asked for.
size_t target_found_size(const reach_work *w);

// A team_work: context is a reach_work, result a target_found.
status reach_target(void *context, int item, void *result);
