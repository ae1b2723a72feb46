// measure/fit_spread.h
// How sure fitted numbers are.
#pragma once

#include "measure/fit_inside.h"

typedef struct fit_spread {
    int bound[FIT_MOST_UNKNOWNS];
    double beyond[FIT_MOST_UNKNOWNS];    // where the data alone would have it
    double deviation[FIT_MOST_UNKNOWNS]; // its standard error there, not scaled
} fit_spread;

// The standard error of the k-th free unknown, which is about to be held at its bound.
status fit_spread_held(fit *f, const double *z, int k, fit_spread *spread);

// Values, standard errors, intervals and correlation at z; ERR_NUMERIC where unknowns cannot be
// told apart, by name.
status fit_spread_find(fit *f, const double *z, double cost, const fit_spread *spread,
                       fit_answer *out);

// ERR_NUMERIC where the free unknowns cannot be told apart at z, by name.
status fit_told_apart(fit *f, const double *z);
// "'E soft' and 'E stiff' together": what the shapes at z tell least of.
void fit_weakest(fit *f, const double *z, char *words, size_t room);
