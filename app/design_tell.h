// app/design_tell.h
// What is told of a design search: its rows, and the case file with the found design.
#pragma once

#include "app/chain.h"
#include "reach/design.h"

status design_tell(const case_data *c, const design_answer *a, reach_design_result *out);

// The case with the design x, NUL at its end; the caller's.
status design_case_text(const case_data *c, const reach_design_result *d, const double *x,
                        char **out);
