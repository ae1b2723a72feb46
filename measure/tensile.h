// measure/tensile.h
// Young's modulus from tensile curves, by a stated rule                   docs/theory.md (9.80) to
// (9.88)
//
// A parabola is laid through the straight stretch of the first loading, and E is its slope where
// its stress is zero: the bend of the stretch is in the interval, not in the number. The stretch
// is the one that gives E most closely among those that pass for straight; what is less steep
// than the steepest of them, or soon left behind by the curve, as the toe is, does not count.
#pragma once

#include "base/status.h"

#include <stdbool.h>

typedef struct tensile_curve {
    int n;
    double *strain, *stress; // [n] in the order of time; engineering strain [-], stress [Pa]
} tensile_curve;

status tensile_curve_make(int n, tensile_curve *out);
void tensile_curve_free(tensile_curve *c);

typedef struct tensile_rule {
    double share;     // of the interval: 0.95
    double departure; // of the stress from the line, as a share of it, that ends the linear range
} tensile_rule;

tensile_rule tensile_rule_default(void);

enum { TENSILE_FEWEST = 10 }; // points of a first loading

typedef struct tensile_answer {
    double E, standard_error, interval[2]; // [Pa]
    double freedom;                        // degrees of freedom behind the interval
    double strain_offset;   // where the line meets zero stress: strain counts from there
    double linear_strain;   // end of the linear range of the line of E, from there
    bool linear_to_end;     // the curve never left the line: linear_strain is where it ends
    double window[2];       // the straight stretch, in the strain of the curve
    double noise;           // standard deviation of the stress about the parabola [Pa]
    double correlation;     // points that go together: 1 for white noise
    int nwindow;            // points in the stretch
    int nloading;           // of the first loading
    int nduplicate, nspike; // points left out
    bool unloads;           // there was more after the first loading
    bool turned;            // compression: both signs were turned
    double end;             // strain of the first loading's end
    double slip;            // strain at which the sample slipped; NAN: it did not
} tensile_answer;

// ERR_FILE where it has too few points, or no straight stretch: the message is to follow a name.
status tensile_measure(const tensile_curve *c, const tensile_rule *rule, tensile_answer *out);

typedef struct tensile_pool {
    int n; // curves in the number
    double E, standard_error, interval[2], freedom;
    double between;       // standard deviation from sample to sample [Pa]; NAN for one
    double linear_strain; // of several: the median, the lower one of two
    double own;           // standard error of a curve by itself, root mean square [Pa]
    double next; // half the interval that one more such curve lets expect [Pa]; NAN for one
} tensile_pool;

// Curves of one material: random effects after Paule and Mandel, the interval after Hartung and
// Knapp. used[i]: whether the curve counts.
status tensile_pool_of(int n, const tensile_answer *a, const bool *used, const tensile_rule *rule,
                       tensile_pool *out);

// The linear range of the pooled E instead: of the weighted mean of the curves about its line
// (9.86)
status tensile_pool_linear(int n, const tensile_curve *const *c, const tensile_answer *a,
                           const bool *used, const tensile_rule *rule, tensile_pool *p);

// Grubbs's test, two-sided at 5 %, one after another while four or more are left.
status tensile_outliers(int n, const tensile_answer *a, bool *outlier);
