// measure/fit_inside.h
// Inside of shape_fit: stations, the model at them, residuals and their derivatives.
#pragma once

#include "measure/gsl_door.h"
#include "measure/shape_fit.h"

typedef struct fit_station {
    int shape;
    bool first; // of its shape among those used
    double s;   // along the measured line [m]
    vec3 at;    // measured [m]
    vec3 across[2];
    double sigma; // NAN: not known
} fit_station;

// The best place where a search stopped short.
typedef struct fit_stop {
    bool any;
    double chi2, x[FIT_MOST_UNKNOWNS];
    char weakest[400]; // the combination of unknowns that the shapes tell least of
} fit_stop;

typedef struct fit {
    const fit_problem *problem;
    const gsl_fit_door *door;
    int nall;         // stations that the lines offer ...
    fit_station *all; // ... at steps of about `step`, shape after shape
    double step;      // [m]
    int nuse, *use;   // [nuse] of them that are used
    double length;    // over which errors go together [m]; 0: not at all
    int length_from;  // fit_correlation
    double sigma;     // where a line does not tell its own [m]
    double *scale;    // [nunknown] of the search's coordinates
    double *x;        // [nunknown] the values at hand
    int nfree, *free; // [nfree] unknowns that are searched; the others stay at x
    int nbase;        // motions of the base

    // the model's places at all stations for the values `at`, and their derivatives
    double *at;
    bool solved, derived, begun;
    vec3 *q, *dq; // [nall], [nunknown][nall]
    vec3 *p;      // [nshape][FIT_POINTS]
    vec3 *tip;    // [nshape] of the model
    vec3 *slope;  // [nall] the model's direction there, of the last shapes solved
    int nsolve;

    fit_stop stop;
    bool named; // the last search ended by unknowns that cannot be told apart
    int start;  // the search at hand, from 0
} fit;

status fit_make(const fit_problem *problem, fit *out);
void fit_free(fit *f);

// Which stations are used: every stride-th of each shape.
void fit_use(fit *f, int stride);

// The two directions across a line that runs along d.
void fit_set_across(fit_station *t, vec3 d);

// q at all stations for x, tips too; ERR_NUMERIC where the model has no shape there.
status fit_places(fit *f, const double *x, vec3 *q);
// fills f->q (and f->dq by differences) for x, between the bounds
status fit_solve(fit *f, const double *x);
status fit_derive(fit *f, const double *x);
// dq of one unknown by steps of `part` of its scale, inside the bounds [nall]
status fit_difference(fit *f, const double *x, int unknown, double part, vec3 *dq);

// Coordinates of the search z: the free unknowns over their scales from their starts, then the
// base's motions in standard deviations.
int fit_nz(const fit *f);
int fit_nr(const fit *f);
status fit_residuals(void *fit, const double *z, double *r, double *jacobian);
pose fit_base_pose(const fit *f, const double *z, int shape);
double fit_sigma(const fit *f, const fit_station *t);

// sigma and the correlation along the lines by the residuals at z
void fit_learn(fit *f, const double *z);

// Normal equations of the free unknowns at z with the base's motions eliminated [nfree][nfree], in
// the search's coordinates, and with them held [nfree] (its diagonal).
status fit_normal(fit *f, const double *z, double *S, double *held);

// One search from z [fit_nz] to the best place near; ERR_NUMERIC: none within the budget, f->stop
// has what was reached.
status fit_search(fit *f, double *z, double *cost);
// whether further searches would say the same
bool fit_in_vain(const fit *f);
// The last search's failure, and where the best of them stood.
status fit_no_search_ended(fit *f, int nstart);
