// app/design_score.h
// How good a design is: what its scope reaches.                docs/theory.md (10.30), (10.31)
#pragma once

#include "app/reach_run.h"

typedef struct design_scoring {
    const case_data *c;
    const reach_scene *scene;
    variation *base;  // laws of the case as it stands
    int scope;        // whose rod is varied
    double length;    // of which lengths count as short and long in the score [m]
    int nmap;         // places of the surface, where the area is maximised
    double (*map)[3]; // [nmap]
} design_scoring;

// The score of a design x, as design_problem has it; context is a design_scoring. goal: targets
// reached, or the share of the places.
status design_score(void *context, const double *x, double *goal, double *score);

// How near a target is to being reached, in [0, 1]: out of reach up to 1/3, colliding up to 2/3,
// reached from there on, more with more room.
double design_closeness(const reach_answer *a, double tolerance, double clearance, double length);
