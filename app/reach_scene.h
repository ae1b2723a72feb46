// app/reach_scene.h
// Where a case's scopes move: the tissue, the targets in it, the line on which they come in.
#pragma once

#include "app/case.h"
#include "reach/distance.h"
#include "reports/reach_result.h"

typedef struct reach_scene {
    char path[REACH_TEXT]; // of the tissue, for messages
    surface tissue;
    surface_report report;
    distance_tree *tree;
    pose entry;               // z along the line
    double free;              // of the line, from the entry on: the channel [m]
    double shaft_free;        // so far the shaft has room, and beyond the channel more and more [m]
    int ntarget;              // 0: none
    char (*name)[REACH_NAME]; // [ntarget]
    double (*target)[3];      // [ntarget] [m]
    double *depth;            // [ntarget] from the wall, positive inside [m]
} reach_scene;

// Reads the files that the case names. ERR_FILE where one is damaged, ERR_INPUT with its place
// where they do not go together: another unit, a line that misses or has no room, targets outside.
// In place: *out must not move.
status reach_scene_open(const case_data *c, reach_scene *out);
// ERR_INPUT where a tip of this length [m] and the tissue differ as only units do.
status reach_scene_fits(const case_data *c, const reach_scene *s, double length);
void reach_scene_free(reach_scene *s);
