// fem/segment_plan.h
// Which meshes a segment is solved on: one rung of the ladder towards its tolerance after another.
// docs/theory.md (5.15)
#pragma once

#include "fem/segment.h"

typedef struct segment_plan {
    segment_mesh mesh; // of the section
    int order;         // along s
    int nlayer;
    double *layer; // [nlayer + 1] s where layers begin and end [m]
} segment_plan;

// The rungs from which to which the case goes: two at least where there is an estimate to be had,
// the first one solved for nothing else.
typedef struct segment_climb {
    int first, last;
} segment_climb;
segment_climb segment_climb_of(const segment_case *c);

status segment_plan_make(const segment_case *c, const segment_source *source, int rung,
                         segment_plan *out);
void segment_plan_free(segment_plan *p);

// What the difference of two rungs that follow each other is multiplied by for the error of the
// second: of its motions and of the middle's law.
// grows: the section's mesh has more nodes than the rung below's.
double segment_plan_factor(const segment_case *c, const segment_source *source, int rung,
                           bool grows);
double segment_plan_law_factor(const segment_case *c, int rung);
