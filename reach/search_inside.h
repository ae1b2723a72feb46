// reach/search_inside.h
// What the two searches share.
#pragma once

#include "reach/inverse_inside.h"
#include "reach/search.h"

typedef struct search {
    const inverse *inv;
    scope_state *state;
    vec3 target;
    const room_probe *room;
    const search_options *options;
    search_answer *out;
} search;

// The room at a pose, as far as wished for; keeps the best of those whose tip is near enough, whose
// room is that of room->at. wish->first becomes the place where it was least.
status search_look(search *s, const inverse_pose *pose, clearance_wish *wish, double *room);

// Steps from a pose to more room until there is none, or enough of it.
status search_lead(search *s, inverse_pose pose);

// search_boxes.c, search_starts.c
status search_boxes(search *s);
status search_starts(search *s);
