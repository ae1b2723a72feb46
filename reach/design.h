// reach/design.h
// Numbers in bounds that make a score largest, where one score takes long and may jump: by NLopt,
// from several seeds side by side (islands), on all cores and, under mpirun, on many machines;
// resumable.                                           docs/theory.md (10.30) to (10.33)
#pragma once

#include "base/hash.h"
#include "base/status.h"

#include <stdbool.h>

enum { DESIGN_MOST = 16, DESIGN_MOST_ISLANDS = 1000, DESIGN_MOST_EVALUATIONS = 100000 };

// x at which a design was looked at, and what came out.
typedef struct design_trial {
    double x[DESIGN_MOST];
    double goal, score; // NAN: it has no answer
    int island;         // from 0
    int evaluation;     // from 1; 0: none was made
    bool reused;        // it stood in the log
} design_trial;

typedef struct design_news {
    int done, total, failed; // evaluations
    double goal, score;      // of the best so far; NAN: none yet
} design_news;

typedef struct design_problem {
    int nparameter;
    const double *lower, *upper, *start; // [nparameter]
    // The larger the better, never negative; runs in a worker. The same x gives the same numbers.
    // Where it fails this design has no answer and is the worst, unless the failure is an
    // interrupt, of this machine or our own mistake.
    status (*score)(void *context, const double *x, double *goal, double *score);
    void *context;
    // > 0: a score lies from this times its goal to below one more than that, and a line of the log
    // that says another is damaged                                       docs/theory.md (10.30)
    double per_goal;
    int islands, evaluations; // searches, and how often each may ask for a score
    int seed;
    int workers; // 0: as many as there are cores. The answer does not depend on it
    // Every evaluation as a line; what stands there is not computed again. Under mpirun each rank
    // but the first has its own, LOG.1 and so on. NULL: none.
    const char *log;
    hash problem; // of all that the score depends on: another problem's log is refused
    status (*heard)(void *context, const design_news *news); // now and then; may be NULL
    void *hearer;
} design_problem;

typedef struct design_answer {
    int islands, evaluations;
    design_trial *trial; // [islands][evaluations]; owned
    int best;            // index of the first one with the largest score
    int done, failed, reused;
} design_answer;

// The same on all ranks of an mpirun, whatever their number. ERR_NUMERIC where no design has an
// answer.
status design_search(const design_problem *p, design_answer *out);
void design_answer_free(design_answer *a);
