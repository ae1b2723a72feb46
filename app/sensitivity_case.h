// app/sensitivity_case.h
// What a case says about the parameters that may move its answer: `sensitivity`.
#pragma once

#include "base/key.h"

enum {
    SENSITIVITY_PARAMETERS = 40,
    SENSITIVITY_SOLUTIONS = 1000, // looked at; of more the case chooses
    MONTE_CARLO_SAMPLES = 100000,
};

typedef enum draw_kind { DRAW_UNIFORM, DRAW_NORMAL } draw_kind;

typedef struct monte_carlo_case {
    mark at;
    int samples, seed;
} monte_carlo_case;

typedef struct sensitivity_case {
    mark at;
    key_list parameters; // of sensitivity_parameter (app/sensitivity.h); none: a list of our own
    key_rows solutions;  // from 1, a row; none: all
    monte_carlo_case monte_carlo;
} sensitivity_case;

extern const key_table sensitivity_keys; // `sensitivity`
