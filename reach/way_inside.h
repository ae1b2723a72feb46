// reach/way_inside.h
// What the parts of the way share: poses by insertion, turn and the share of the bend.
#pragma once

#include "reach/way.h"

enum { WAY_SHARES = 48, WAY_SAMPLES = 16 };

typedef struct way_pose {
    double insertion, turn, share;
    double room;
} way_pose;

typedef struct way_search {
    scope_state *state;
    const room_probe *room;
    const double *goal;
    double least, resolution;
    int most_looks;
    way_answer *out;
    double rest[SCOPE_JOINTS]; // the bending joints, unbent
    // at share k / WAY_SHARES: no point of the tip has moved farther from that before than the
    // difference; none is farther from the line than this
    double moved[WAY_SHARES + 1], farthest[WAY_SHARES + 1];
} way_search;

void way_joints(const way_search *w, const way_pose *p, double q[SCOPE_JOINTS]);
status way_look(way_search *w, way_pose *p);

// No point of the body moves farther from one to the other, along the straight line in the joints.
double way_motion(const way_search *w, const way_pose *a, const way_pose *b);

// Whether there is room all the way from a to b; *bound: nowhere less.
status way_between(way_search *w, const way_pose *a, const way_pose *b, bool *free, double *bound);

// way_grid.c: the widest way over a grid with so many turns
status way_over_grid(way_search *w, int turns);
