// measure/shape_error.h
// How far a model's centreline lies from a measured one, docs/theory.md section 9.
//
// Both are curves over the arclength of the unloaded rod, in the frame of its base: the model a
// cubic in Hermite's form between its stations, the measured line a cubic through four neighbours
// (centreline_at). All integrals are those of these two curves, whatever their stations: the pieces
// between the stations of both are halved until nothing changes.
#pragma once

#include "measure/centreline.h"

#include <stdbool.h>

// A model's line; all arrays are the caller's.
typedef struct model_line {
    int count;         // 2 or more
    const double *s;   // [count] arclength of the unloaded rod [m], ascending from 0 to its length
    const vec3 *p;     // [count] [m]
    const vec3 *slope; // [count] dp/ds [-]
    const double *along; // [count] arclength of the loaded rod [m]: model_line_lengths
} model_line;

vec3 model_line_at(const model_line *m, double s);
// The arclength of the model as it lies, at its stations: along [count].
void model_line_lengths(const model_line *m, double *along);

// What the measured arclength runs along.
typedef enum shape_arclength {
    ARCLENGTH_MEASURED, // the line as it lies: taken back to the unloaded rod by the model's
                        // stretch, and tip to tip where the tip was measured
    ARCLENGTH_REST,     // the unloaded rod already
} shape_arclength;

// Whether a measured line ends at the rod's tip: where its length says so, or as
// told.
typedef enum shape_tip { TIP_BY_LENGTH, TIP_MEASURED, TIP_NOT_MEASURED } shape_tip;

// A line as long as the model's to this share of the length ends at the tip: the model's own
// stretch is some per cent, and seldom wrong by half of it.
#define SHAPE_TIP_SHARE 0.02
// One that is longer has the tip too: the body ends where it ends, and the model is short. By more
// than this it hardly is the same rod.
#define SHAPE_TIP_LONGER 0.1
// Of an arclength that is told to be the rod's own, rounding and a scanner's last step.
#define SHAPE_REST_SHARE 1e-3

typedef struct shape_way {
    int arclength; // shape_arclength
    int tip;       // shape_tip
} shape_way;

// Whether a measured line that ends at `end` ends at the tip of a model of this length; both along
// what way->arclength says.
bool shape_ends_at_tip(const shape_way *way, double end, double length);

// The measured line over the arclength of the unloaded rod. *tip: whether it ends at the tip;
// *longer: how much longer it is than the model's [m].
//   s = along^-1(sigma along(L) / sigma_end)      docs/theory.md (9.51)
status shape_match(const model_line *m, const centreline *measured, const shape_way *way,
                   centreline *out, bool *tip, double *longer);

typedef struct shape_error {
    double from, to;       // what was measured of the unloaded rod's arclength [m]
    double longer;         // the measured line than the model's [m]
    double tip, tip_sigma; // |p(L) - p_measured(L)|, its standard uncertainty [m]; NAN: the tip was
                           // not measured, sigma unknown
    double tip_angle, tip_angle_sigma; // between the tangents there [rad]; NAN likewise
    double shape, shape_sigma;         // the paper's shape error [-]
    double mean, rms;                  // distance over the arclength [m]
    double largest, at;                // the largest distance, and its arclength [m]
    double base;                       // distance at s = 0 [m]; NAN: not measured there
} shape_error;

// matched: of shape_match; `tip` as it told. ERR_INPUT where nothing of the rod was measured.
//   shape = 1/(to - from) int |p - p_measured| / s ds      docs/theory.md (9.52)
status shape_error_find(const model_line *m, const centreline *matched, bool tip, shape_error *out);

// How a measured line turns per arclength at its stations, by parabolas through the stations within
// `window` of arclength: b = p' x p'' / |p'|^2 [1/m], and the standard uncertainty of each of its
// components. NAN where less than the whole window, or fewer than four stations, were measured.
//   docs/theory.md (9.56)
void centreline_bend(const centreline *c, double window, vec3 *bend, double *sigma);
