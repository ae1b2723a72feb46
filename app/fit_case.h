// app/fit_case.h
// What a case says about fitting its open numbers to measured shapes.
#pragma once

#include "app/parameter.h"

typedef struct fit_parameter {
    parameter what;
    double start, lower, upper; // in the keys' unit; NAN: no bound
} fit_parameter;

typedef struct fit_case {
    mark at;
    key_list parameters; // of fit_parameter
    int base;            // fit_base
    double base_shift;   // standard deviation of each component [m]
    double base_turn;    // [rad]
    int starts, seed;
    double interval; // share of the intervals
} fit_case;

extern const key_table fit_keys; // `fit`
fit_case fit_case_default(void);

bool case_has_fit(const struct case_data *c);
// ERR_INPUT where the case has no fit, or nothing measured.
status case_need_fit(const struct case_data *c);

// Names, bounds, keys that the case does not have; once the rest of the case is bound.
status case_fit_check(const struct case_data *c);

// The parameters at their starts, for a variation.
status fit_case_start(const fit_case *f, settings *out);
