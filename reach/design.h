// reach/design.h
// Numbers in bounds that make a score largest: by NLopt, from several seeds side by side,
// resumable.
#pragma once

#include "base/status.h"

#include <stdbool.h>

enum { DESIGN_MOST = 16 };

typedef struct design_problem {
    int nparameter;
    const double *lower, *upper, *start; // [nparameter]
    // the larger the better; not OK: this design has no answer and counts as the worst, unless the
    // failure is an interrupt or of this machine (status code)
    status (*score)(void *context, const double *x, double *goal, double *score);
    void *context;
    int islands, evaluations, seed;
    const char *
        log; // every evaluation, one line each; what stands there is not computed again. NULL: none
} design_problem;

typedef struct design_trial {
    double x[DESIGN_MOST];
    double goal, score; // NAN: failed
    int island, evaluation;
} design_trial;

typedef struct design_answer {
    int ntrial;
    design_trial *trial; // [ntrial] by island, then evaluation; owned
    int best;
    int failed, reused;
} design_answer;

status design_search(const design_problem *p, design_answer *out);
void design_answer_free(design_answer *a);
