// measure/shape_fit.h
// Unknown numbers of a model by least squares from measured shapes, docs/theory.md section 9.
//
// What is compared is the place across the measured line: where a point sits along it nobody
// measured. Errors of neighbouring points go together; what is fitted, and how sure, takes that
// into account by a first-order autoregression along each line (9.62). Each scan may lie a little
// off the model's base (9.61).
#pragma once

#include "measure/centreline.h"

#include <stdbool.h>

typedef struct fit_unknown {
    const char *name;
    double start, lower, upper; // lower < start < upper or at them; infinite: no bound
} fit_unknown;

typedef struct fit_shape {
    const char *name;
    const centreline *line; // in the frame of the rod's base
    bool rest;              // its arclength is the unloaded rod's; else that of the line as it lies
    bool to_tip;            // it ends at the rod's tip
} fit_shape;

// How the measured shapes may lie off the model's base: not at all, all alike, each for itself.
typedef enum fit_base { FIT_BASE_FIXED, FIT_BASE_COMMON, FIT_BASE_EACH } fit_base;

typedef struct fit_problem {
    int nunknown, nshape;
    const fit_unknown *unknown; // [nunknown]
    const fit_shape *shape;     // [nshape]
    // The model's lines for the unknowns' values: p [nshape][FIT_POINTS] at equal steps of the
    // unloaded rod's arclength, *length its length [m]. ERR_NUMERIC: no shape for these values, a
    // search turns elsewhere; what else fails ends it.
    status (*lines)(void *context, const double *x, vec3 *p, double *length);
    // told now and then: search `start` from 0 stands at chi2; NULL: nobody asks
    void (*progress)(void *context, int start, double chi2);
    void *context;
    int base;                     // fit_base
    double base_shift, base_turn; // standard deviations of each of its components [m, rad]
    int nstart;                   // searches, the first from `start`, the others from random places
                                  // between the bounds
    unsigned long seed;
    double share; // of the intervals: 0.95
} fit_problem;

enum { FIT_POINTS = 241, FIT_MOST_UNKNOWNS = 20, FIT_MOST_STARTS = 100, FIT_MOST_STATIONS = 400 };

// Where the errors' going together was taken from.
typedef enum fit_correlation { FIT_BY_RESIDUALS, FIT_BY_LINE } fit_correlation;

// How one shape fits: before (at the start) and after.
typedef struct fit_match {
    int nstation;
    double *s;              // [nstation] along the measured line [m]
    double *before, *after; // [nstation] distance across the line [m]
    double rms[2], tip[2];  // of these; of the tips, in space, NAN where no tip was measured [m]
    vec6 base;              // the measured shape lies off by this: (shift [m], turn [rad])
} fit_match;

typedef struct fit_answer {
    int nunknown, nshape;
    double *value, *error; // [nunknown]; error NAN at a bound
    double *low, *high;    // [nunknown] of the interval, cut at the bounds
    int *bound;            // [nunknown] -1, 1: ends at its lower, upper bound; 0: between
    double *beyond;        // [nunknown] where the data alone would have it; NAN where between
    double *correlation;   // [nunknown][nunknown]; NAN at bounds
    double condition;      // of the correlation matrix
    double chi2;           // of all residuals in standard deviations, base included
    int freedom;
    double scale; // by which standard errors were made larger (or, where sigma was not known, made)
    double quantile; // Student's, of the intervals
    bool sigma_known;
    double sigma; // of a place across the line where the lines do not tell [m]; else NAN
    double correlation_length; // along the line [m]
    int correlation_from;      // fit_correlation
    int nplace;                // stations used
    int nstart, nended, nsame; // searches, those that converged, and those that ended here
    double next_chi2;          // the best that ended elsewhere; NAN: none
    double step_error;         // of the derivatives by differences, relative
    int nsolve;                // of the model
    fit_match *match;          // [nshape]
} fit_answer;

// ERR_INPUT: more unknowns than data; ERR_NUMERIC: no convergence, or unknowns that these shapes do
// not tell apart, by their names.
status shape_fit(const fit_problem *problem, fit_answer *out);
status fit_answer_make(int nunknown, int nshape, fit_answer *out); // room for what has no stations
status fit_match_make(int nstation, fit_match *out);
void fit_answer_free(fit_answer *a);
