// measure/tensile_inside.h
// Inside of the rule for Young's modulus.
#pragma once

#include "measure/gsl_door.h"
#include "measure/gsl_line_door.h"
#include "measure/tensile.h"

// --- the first loading (tensile_loading.c)

// The points of the first loading without duplicates and spikes, up to a slip; fills what `a` says
// of them.
status tensile_loading(const tensile_curve *c, tensile_curve *out, tensile_answer *a);

// At most `most` points up to the strain `end`: neighbours' means.
status tensile_thin(const tensile_curve *c, double end, int most, tensile_curve *out);

// --- a parabola through a stretch (tensile_parabola.c)

enum { CUBIC = 4 };

typedef struct tensile_stretch {
    int first, count; // of the points
    double from, to;  // strains
} tensile_stretch;

typedef struct tensile_fit {
    double p[CUBIC], se[CUBIC]; // of y/scale = sum p_k t^k, t = (x - from)/(to - from)
    double V[CUBIC][CUBIC];     // covariance
    double scale;
    double tau; // points that go together
    double freedom, noise;
} tensile_fit;

// degree 1 to 3; tau 0: from its own residuals.
status tensile_polynomial(const gsl_line_door *door, const tensile_curve *c, tensile_stretch s,
                          int degree, double tau, tensile_fit *out);

// Sum of the autocorrelation of residuals of `fitted` coefficients, 1 for white noise; bounded by
// n/8.
double tensile_correlation(int n, const double *r, int fitted);

// --- which stretch (tensile_window.c)

typedef struct tensile_choice {
    tensile_stretch stretch;
    double E, se, zero; // zero: strain at which the line has no stress
    tensile_fit fit;
} tensile_choice;

// `whole`: the loading of which c is the beginning.
status tensile_choose(const gsl_line_door *door, const tensile_curve *c, const tensile_curve *whole,
                      tensile_choice *out);

// --- how far it is straight (tensile_linear.c)

// The line is that of E. The linear range ends where the curve, in means over neighbours, was last
// within the share of the line's stress before it is, behind the toe, surely further off    (9.85)
void tensile_linear_range(const tensile_curve *c, const tensile_choice *w, double departure,
                          tensile_answer *a);
