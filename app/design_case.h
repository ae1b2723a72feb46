// app/design_case.h
// What a case says of the design that is searched for: numbers with names, and keys by expressions
// in them.
#pragma once

#include "app/case.h"
#include "app/parameter.h"

bool case_has_design(const case_data *c);
// ERR_INPUT where there is no `reach.design`, or what it says does not go together.
status case_need_design(const case_data *c);
status case_design_check(const case_data *c);

const design_parameter_case *case_design_parameter(const case_data *c, int i);
int case_design_scope(const case_data *c); // number of the scope whose rod is varied

// KEY=EXPRESSION of the design with the parameters' names replaced by the numbers x.
status design_settings(const case_data *c, const double *x, settings *out);

// The same with every parameter's `start` too, for a case file that begins at this design; keys of
// another case than c (the scope's rod is from a file) go to the scope's `rod.set`.
status design_case_settings(const case_data *c, const double *x, settings *out);

// `text` with whole words that are names [n] replaced by (value), or by the value where there is
// nothing else; numbers, keys of maps within it and all else are left as they are. The caller frees
// it.
status design_words(const char *text, int n, const char *const *name, const double *value,
                    char **out);
