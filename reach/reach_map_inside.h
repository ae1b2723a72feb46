// reach/reach_map_inside.h
// What the parts of the map share.
#pragma once

#include "reach/inverse_inside.h"
#include "reach/joint_boxes.h"
#include "reach/reach_map.h"
#include "reach/sample_grid.h"

typedef struct mapping {
    const inverse *inv;
    scope_state *state;
    const room_probe *room;
    const reach_map_options *options;
    reach_map_answer *out;
    sample_grid samples;
    bool *maybe; // [npoint] a box that is not divided may reach it
    const bend_sweep *sweep;
    const double *bend; // more than one bending joint: these, whatever the box's; else NULL
    bend_sweep still;   // a sweep of one value, for them
    bend_node still_node[2];
    double resolution;
    box_heap heap;
    const double *q; // of the pose that is marking
} mapping;

// Branch and bound over the whole sweep, down to the resolution.
status map_boxes(mapping *m);

// reach_map_many.c: more than one bending joint
status map_many(mapping *m);
