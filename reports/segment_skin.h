// reports/segment_skin.h
// The whole surface of a segment as triangles, with how each of their corners moves under a load:
// for pictures that are turned. Loads of one body have the same corners and triangles.
#pragma once

#include "reports/result.h"

typedef struct segment_skin {
    int nvertex, ntriangle;
    double (*at)[3];         // [nvertex] at rest [m]
    double (*move)[3];       // [nvertex] [m]
    double *value;           // [nvertex] size of the displacement [m]
    unsigned char *material; // [nvertex]; corners are apart where materials meet
    int (*triangle)[3];      // [ntriangle]
} segment_skin;

// The segment has all its levels here, and the load its displacements: ERR_BUG else.
status segment_skin_make(const segment_body *body, const segment_load_result *load,
                         segment_skin *out);
void segment_skin_free(segment_skin *s);
