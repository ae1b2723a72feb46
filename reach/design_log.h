// reach/design_log.h
// Designs that were looked at, as lines of a file that is only ever appended to:
//   # stiffaxis design log 1 FINGERPRINT NPARAMETER
//   island,evaluation,goal,score,x1,...
// A line that was cut off when the program ended, the first one too, is left out and overwritten.
// One search at a time writes it.
#pragma once

#include "reach/design.h"
#include "reach/ranks.h"

typedef struct design_log {
    int nparameter;
    int ntrial;
    design_trial *trial; // [ntrial] ascending by x
    int file;            // -1: none is written
} design_log;

// Begins the file where there is none. ERR_FILE where it is no such log or damaged, ERR_INPUT where
// it is of another problem, ERR_RESOURCE where another search writes it: then it is not touched.
// p->log NULL: an empty log that keeps nothing.
status design_log_open(const design_problem *p, const ranks *r, design_log *out);
void design_log_close(design_log *l);

// NULL: not there. Exactly this x.
const design_trial *design_log_find(const design_log *l, const double *x);
// One line; workers may do so at once.
status design_log_add(const design_log *l, const design_trial *t);
