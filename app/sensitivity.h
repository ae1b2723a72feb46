// app/sensitivity.h
// What moves the answer: the case solved with other values of its parameters.
#pragma once

#include "app/command.h"
#include "app/variation.h"
#include "reports/result.h"

_Static_assert((int)SENSITIVITY_PARAMETERS <= (int)MOST_MOVERS,
               "a result holds what a case may ask");

// One of sensitivity.parameters: a range, an alternative, or a spread.
typedef struct sensitivity_parameter {
    parameter p;
    double low, high;     // in the keys' unit; NAN: not given
    key_text alternative; // any value, as the case would have it
    int distribution;     // draw_kind
    double sigma;         // of the normal one, in the keys' unit; NAN: not given
} sensitivity_parameter;

// Everything in place, names and keys known, ranges the right way round: ERR_INPUT with its place.
status sensitivity_check(const case_data *c);

// The list that suits any case, where it names none: tendon radii, Poisson's ratio, the stiffest
// modulus, friction, the section's model. Texts are the list's own.
enum { DEFAULT_PARAMETERS = 8, DEFAULT_TEXTS = 600 };
typedef struct default_list {
    sensitivity_parameter parameter[DEFAULT_PARAMETERS];
    int count;
    key_text keys[DEFAULT_TEXTS];
    char (*text)[96]; // [DEFAULT_TEXTS], owned
    int ntext;
} default_list;
status sensitivity_defaults(const case_data *c, default_list *out); // in place
void sensitivity_defaults_free(default_list *d);

// One study of a case: its parameters, its rod as it stands, and what is solved beside it.
typedef struct sensitivity_study {
    const command *cmd; // progress
    const case_data *c;
    const sensitivity_parameter *parameter; // [out->nmover]
    variation v;
    variation_answer base; // the solutions as the case stands
    double *bend;          // [nsolution]
    sensitivity_result *out;
} sensitivity_study;

// The total bends of an answer's shapes [nsolution].
void sensitivity_bends(const variation_answer *a, double *bend);
// All solutions with some settings, with enough points to follow the bend.
status sensitivity_solve(sensitivity_study *s, const settings *with, mark at,
                         variation_answer *out);

// app/sensitivity_rates.c: derivatives of all solutions by one parameter.
status sensitivity_rates(sensitivity_study *s, int parameter);
// app/sensitivity_draw.c, monte_carlo.c: samples of all parameters that have a range.
status sensitivity_monte_carlo(sensitivity_study *s);

// Into out->sensitivity; after chain_rods.
status chain_sensitivity(const command *cmd, const case_data *c, run_result *out);
