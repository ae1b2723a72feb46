// io/expression.h
// muParser's one door: arithmetic in pi, L, s and, over a section, x and y.
//
// Allowed: decimal numbers, + - * / ^ ( ), comparisons, && || and ? :, and the functions sin cos
// tan asin acos atan atan2 sinh cosh tanh asinh acosh atanh exp ln log (natural, as ln) log2 log10
// sqrt abs rint sign min max sum avg. No assignment, no texts, one result. The decimal point is a
// point in every locale. In a case file `a ? b : c` wants quotes, since ': ' is YAML's own.
#pragma once

#include "base/status.h"

#include <stdbool.h>

typedef struct calculator calculator; // owns every expression it compiled
typedef struct expression expression;

status
calculator_make(calculator **out);   // starts nothing: muParser begins with the first arithmetic
void calculator_free(calculator *c); // NULL is fine

typedef struct expression_scope {
    bool has_L, has_s;
    bool has_place;   // x and y
    double L;         // in the unit that the caller chose
    const char *no_L; // why it is missing, for the message: "the case has no length yet"
    const char *no_s;
} expression_scope;

typedef struct expression_error {
    int position; // of the character in the text, from 0
    char words[240];
} expression_error;

// ERR_INPUT with *error filled (no message kept: the caller knows the place), ERR_RESOURCE out of
// memory. The value may be infinite or NaN (1/0).
status expression_value(calculator *c, const char *text, const expression_scope *scope,
                        double *value, expression_error *error);

// Compiled once; expression_at takes some 20 ns plus its functions. Not to be evaluated by two
// threads at once.
status expression_compile(calculator *c, const char *text, const expression_scope *scope,
                          const expression **out, expression_error *error);
double expression_at(const expression *e, double s);
double expression_at_place(const expression *e, double x, double y, double s);

// Whether arithmetic knows the name, wherever it may stand: a constant, a function, x or y.
bool expression_knows(const char *name);

// Whether the name of one letter, x, y or s, stands in the text.
bool expression_uses(const char *text, char name);
