// reports/fit_result.h
// What a fit to measured shapes found, for tables, files and pictures.
#pragma once

#include "measure/shape_fit.h"

#include <stddef.h>

enum { FIT_NAME = 64, FIT_UNIT = 24, FIT_KEYS = 400 };

typedef struct fit_parameter_told {
    char name[FIT_NAME], unit[FIT_UNIT], keys[FIT_KEYS]; // unit of the keys' spelling; keys by ", "
    double start, lower, upper;                          // in that unit; infinite: no bound
    double to_si;
} fit_parameter_told;

typedef struct fit_shape_told {
    char name[FIT_NAME];
    int solution;  // of the rod's, from 0
    int turn_free; // 1: its scan is free in its turn about z
} fit_shape_told;

typedef struct fit_result {
    bool there;
    bool synthetic;                // the shapes are not from a bench
    char source[160];              // of the shapes
    int base;                      // fit_base
    double base_shift, base_turn;  // what was known of it beforehand [m, rad]
    double share;                  // of the intervals
    fit_parameter_told *parameter; // [answer.nunknown]
    fit_shape_told *shape;         // [answer.nshape]
    fit_answer answer;             // values in the keys' units
} fit_result;

status fit_result_make(int nparameter, int nshape, fit_result *out);
void fit_result_free(fit_result *f);

// "tendon radius = 3.62 ± 0.03 mm, friction = 0.21 ± 0.02"
const char *fit_result_words(const fit_result *f, char *words, size_t room);

// What is to be said of the shapes whose scan is free in its turn about z; "" where none is.
const char *fit_turn_words(const fit_result *f);

// Digits of a value that its standard error leaves standing: two of the error.
int fit_decimals(double error);
