// reach/reach_map.h
// Which parts of a surface a scope's tip reaches: all points at once, from the joints' side.
//                                                            docs/theory.md (10.10) to (10.12)
#pragma once

#include "reach/clearance.h"
#include "reach/search.h"

// npoint places on the surface, equally many per area: by a sequence of low discrepancy over the
// triangles in their order, shifted by the seed; the same seed gives the same places.
status surface_samples(const surface *s, int npoint, int seed, double (*point)[3]);

typedef struct reach_map_options {
    double near;       // the tip's centre comes within this of a point [m]
    double resolution; // boxes of joints in which the body moves by less are not divided [m]
    int most_looks;    // at the room
    bool (*stop)(void *context, double share_done); // asked now and then; NULL: never
    void *context;
} reach_map_options;

// near 1 mm
reach_map_options reach_map_options_default(void);

typedef struct reach_map_answer {
    int *state; // [npoint] reach_map_state (reports/reach_result.h has the same numbers): 0 proved
                // not to be reached, 1 reached, 2 not known at this resolution; the caller's
    double (*q)[SCOPE_JOINTS]; // [npoint] of a pose that reaches it, whose room is not negative;
                               // the caller's, NULL: not wanted
    double spacing;            // between the tips of neighbouring poses that were looked at, where
                               // the answer hung on it [m]
    int looks;
} reach_map_answer;

// One bending joint: branch and bound, 0 is proved. More: the bending joints by their grid, where
// 0 is what no cell of the grid brings the tip to (10.4). ERR_RESOURCE "stopped" where stop says
// so.
status reach_map(const inverse *inv, scope_state *state, const room_probe *room, int npoint,
                 const double (*point)[3], const reach_map_options *options, reach_map_answer *out);
