// reach/way.h
// A way in: joints from outside to a pose, on which no part of the body touches.
//                                                                  docs/theory.md (10.13), (10.14)
#pragma once

#include "reach/search.h"

enum { WAY_POSES = 512 };

typedef struct way_answer {
    bool found;
    bool straight; // insert first, then bend: nothing else was needed
    double room;   // nowhere on the way is there less, certified between its poses too, to half the
                 // resolution [m]; where none is found: of the widest way among the poses looked at
    int npose; // from the least insertion, unbent, to the pose; 0: none found
    double q[WAY_POSES][SCOPE_JOINTS];
    int looks;
} way_answer;

// From the least insertion with no tension (or bend) to q, with at least the room `least` [m]:
// first straight in and then bent, else the widest way over insertion and the share of the bend,
// else over the turn too. Between two poses that touch nothing and between which the body moves by
// `resolution` [m] or less, nothing is taken to be. Not found is an answer: there may be a way that
// the grid does not have.
status way_find(scope_state *state, const room_probe *room, const double *q, double least,
                double resolution, int most_looks, way_answer *out);
