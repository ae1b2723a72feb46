// reports/store_reach_grid.h
// What ParaView sees of a reach study: the wall with the map on it, and every scope's bodies.
#pragma once

#include "reach/reach_case.h"
#include "reports/result.h"

enum { REACH_PIECES = 1 + REACH_SCOPES, REACH_FIELDS = 2 + REACH_SCOPES };

typedef struct reach_pieces {
    int npiece, nfield;
    char field[REACH_FIELDS][32]; // "clearance_m", "target_count", "scope_1_state" ...
    char name[REACH_PIECES][REACH_NAME + 16];
    mesh mesh[REACH_PIECES];                  // triangles, or lines
    double *data[REACH_PIECES][REACH_FIELDS]; // [nnode]; NULL: not a number
} reach_pieces;

// The state of the map at a corner of the wall is that of the sample nearest to it. Nothing where
// there is no study.
status reach_pieces_make(const reach_result *r, reach_pieces *out);
void reach_pieces_free(reach_pieces *p);
