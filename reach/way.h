// reach/way.h
// A way in: joints from outside to a pose, on which no part of the body touches.
#pragma once

#include "reach/search.h"

enum { WAY_POSES = 512 };

typedef struct way_answer {
    bool found;
    bool straight; // insert first, then bend: nothing else was needed
    double room;   // least on the way, certified between its poses too [m]; where none is found: of
                   // the best
    int npose;     // [npose] from the least insertion, unbent, to the pose
    double q[WAY_POSES][SCOPE_JOINTS];
    int looks;
} way_answer;

// From the least insertion with no tension (or bend) to q: first straight in and then bent, else
// the widest way over insertion, turn and the share of the bend.
status way_find(scope_state *state, const room_probe *room, const double *q, double least,
                double resolution, int most_looks, way_answer *out);
