// reach/joint_boxes.h
// Boxes of insertion, turn and the one bending joint, for branch and bound.   docs/theory.md (10.7)
#pragma once

#include "reach/bend_sweep.h"

enum { BOX_JOINTS = SCOPE_BEND + 1 };

typedef struct joint_box {
    double low[BOX_JOINTS], high[BOX_JOINTS];
    double bound;  // no pose in it has more room
    double motion; // no point of the body moves farther between its middle and another pose of it
    double s;      // where the room was least
    bool free;     // every pose in it has room
} joint_box;

// The box of the largest bound comes first.
typedef struct box_heap {
    joint_box *box; // [most]
    int n, most;
} box_heap;

void box_push(box_heap *h, const joint_box *b); // h->n < h->most
joint_box box_pop(box_heap *h);                 // h->n > 0

// How far the body's points move between the middle and the rest, by each joint; all together by
// no more than box_motion; *tip: its end.
void box_motions(const bend_sweep *w, const joint_box *b, double part[BOX_JOINTS], double *tip);
double box_motion(const double part[BOX_JOINTS]);

// Its halves across the joint that moves the body most.
void box_halve(const bend_sweep *w, const joint_box *b, joint_box half[2]);

// The turn's limits, one full turn of them at most: more are the same poses again.
void box_one_turn(const scope *s, double limit[2]);
