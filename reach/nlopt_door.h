// reach/nlopt_door.h
// The door to NLopt: derivative-free maximisation in a box. No NLopt type passes through.
#pragma once

#include "base/status.h"

// What is maximised at x. OK and a number, always; anything else ends the search, and is what it
// returns.
typedef status nlopt_score(void *context, const double *x, double *score);

typedef enum nlopt_way {
    NLOPT_WAY_GLOBAL, // controlled random search with local mutations (CRS2_LM)
    NLOPT_WAY_LOCAL,  // simplices in subspaces (SBPLX), without random numbers
} nlopt_way;

typedef struct nlopt_job {
    int way;
    int n;
    const double *lower, *upper; // [n]
    double *x; // [n] in: where it begins; out: of no meaning, `score` has seen the best
    const double *step, *resolution; // [n] of LOCAL: the first steps; enough below these
    int population;                  // of GLOBAL, above n
    int evaluations;                 // at most
    unsigned long seed;
    nlopt_score *score;
    void *context;
} nlopt_job;

typedef struct nlopt_door {
    // The same job with the same scores takes the same way, to the last bit.
    status (*maximise)(const nlopt_job *job);
} nlopt_door;

// const nlopt_door *stiffaxis_nlopt_door(void)
#define NLOPT_DOOR_SYMBOL "stiffaxis_nlopt_door"
typedef const nlopt_door *(*nlopt_door_getter)(void);

// Opens the module once.
status nlopt_door_open(const nlopt_door **out);
