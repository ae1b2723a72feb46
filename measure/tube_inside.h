// What the files measure/tube*.c share. Lengths in m; docs/theory.md section "Measurements".
#pragma once

#include "measure/gsl_spline_door.h"
#include "measure/tube.h"

#include <stdint.h>

// --- points in cubic cells (tube_grid.c)

typedef struct tube_grid {
    size_t count, ncell;
    double (*p)[3]; // [count] cell after cell
    double cell;    // edge
    vec3 origin;
    uint64_t *key;   // [ncell] ascending
    uint32_t *first; // [ncell + 1] of p
} tube_grid;

// Points that are no numbers, or too far from `origin` for a key, are left out.
status tube_grid_make(const point_cloud *cloud, vec3 origin, double cell, tube_grid *out);
void tube_grid_free(tube_grid *g);

// The points within `reach` of c: their numbers; at most `room` of them are written.
size_t tube_grid_near(const tube_grid *g, vec3 c, double reach, uint32_t *out, size_t room);

// --- one short curved cylinder (tube_station.c)

typedef struct tube_station {
    vec3 c, t; // centre, and direction of the line there
    vec3 k;    // its curvature vector, across t [1/m]
    double radius;
    double noise; // of the points across the surface
    int used;     // points within three times that
    double angle; // covered near the middle [rad]
    double share; // of the surface within the window that is covered
    bool weak;    // may be a piece of a tube: a strip of it
    bool good;    // is one
} tube_station;

typedef struct tube_window {
    const gsl_spline_door *door;
    size_t count;
    double (*p)[3];    // [count], room for TUBE_WINDOW_POINTS
    double *size;      // [count] work: residuals without sign
    double most_noise; // of a scanner that is believed [m]
} tube_window;

enum { TUBE_WINDOW_POINTS = 3000 };
#define TUBE_HALF_WINDOW 1.25 // radii: of the piece that a cylinder is fitted to

status tube_window_make(const gsl_spline_door *door, tube_window *out);
void tube_window_free(tube_window *w);

// Fits *s (the start in) to the window's points, those first that are within `reach` of its
// surface. s->good tells whether they are a piece of a tube.
status tube_station_fit(const tube_window *w, double reach, bool free_radius, tube_station *s);

// The station `h` further along the arc of s.
tube_station tube_station_ahead(const tube_station *s, double h);

// --- where to begin (tube_seed.c), and on from there (tube_trace.c)

// ERR_FILE where no piece of a tube is found.
status tube_seed(const point_cloud *cloud, const tube_options *options, tube_window *window,
                 tube_station *out);

typedef struct tube_beyond {
    double length, radius; // of a tube of another radius that goes on [m]
} tube_beyond;

typedef struct tube_trace {
    int count, ncylinder;
    tube_station *at;   // [count] from the base on
    tube_beyond beyond; // behind the last one
} tube_trace;

status tube_trace_make(const tube_grid *grid, const tube_station *seed, const tube_options *options,
                       tube_window *window, tube_trace *out);
void tube_trace_free(tube_trace *t);

// --- the line as a quintic spline of its parameter u in [0, length] (tube_curve.c)

enum { TUBE_ORDER = 6, TUBE_MOST_PIECES = 64 };

typedef struct tube_curve {
    const gsl_spline_door *door;
    int npiece, ncoef; // ncoef = npiece + TUBE_ORDER - 1
    double length;
    double *taylor;                 // [npiece][TUBE_ORDER][TUBE_ORDER] of the B-splines
    double (*coef)[3];              // [ncoef]
    double (*power)[TUBE_ORDER][3]; // [npiece] coefficients of powers of (u - middle)
} tube_curve;

status tube_curve_make(const gsl_spline_door *door, int npiece, double length, tube_curve *out);
void tube_curve_free(tube_curve *c);
int tube_curve_piece(const tube_curve *c, double u, double *x); // x: from its middle
void tube_curve_set(tube_curve *c);                             // power from coef
// `derivative`-th derivatives of the splines of a piece, [TUBE_ORDER]
void tube_curve_basis(const tube_curve *c, int piece, double x, int derivative, double *b);
// place and first two derivatives; d1, d2 may be NULL
vec3 tube_curve_at(const tube_curve *c, double u, vec3 *d1, vec3 *d2);
// the parameter of the foot of q near u; beyond the ends it stays outside [0, length]
double tube_curve_foot(const tube_curve *c, vec3 q, double u, int steps);
// P += weight * integral of the derivatives' products; [ncoef][ncoef]
void tube_curve_gram(const tube_curve *c, int derivative, double weight, double *P);
// the smooth curve near n places at u; `smoothing` as in tube_options
status tube_curve_through(tube_curve *c, int n, const double *u, const vec3 *p, double smoothing);
// the same line in its arclength from `from` to `to` (parameters of `c`, may lie outside)
status tube_curve_cut(const tube_curve *c, double from, double to, double radius, tube_curve *out);

// --- the whole line at once (tube_fit.c)

typedef struct tube_fit {
    size_t count;
    double (*p)[3];                  // [count] points near the trace
    double *u, *res, *weight, *work; // [count] feet, residuals, weights
    tube_curve curve;
    double radius; // in the middle
    bool free_radius;
    double radius_sigma;
    double taper; // the radius grows by it from the curve's begin to its end, straight
    bool free_taper;
    double taper_sigma;
    double given_noise, noise, smoothing, given_smoothing, freedom;
    double *covariance; // [3 ncoef + 2]^2, of coefficients, radius and taper
} tube_fit;

status tube_fit_make(const tube_grid *grid, const tube_trace *trace, const tube_options *options,
                     const gsl_spline_door *door, tube_fit *out);
void tube_fit_free(tube_fit *f);
double tube_fit_radius(const tube_fit *f, double u);
// feet, residuals and noise anew
void tube_fit_residuals(tube_fit *f, double reach);
// ends when the line moves by less than a 200th of the noise; `choose`: the smoothing, where
// none is given; `last`: points count as the noise alone says
status tube_fit_solve(tube_fit *f, double reach, bool choose, bool last);
// of the place at u across the line: root mean square of both directions
double tube_fit_sigma(const tube_fit *f, double u);
// mean correlation of the errors across the line at u and v
double tube_fit_correlation(const tube_fit *f, double u, double v);

// --- where the points end (tube_ends.c)

typedef struct tube_end {
    double u, sigma;
    int kind;        // tube_tip
    double straight; // of the line before it: a half ball's radius
} tube_end;

// at the curve's end (side 1) or begin (side -1)
status tube_find_end(const tube_fit *f, int side, tube_end *out);

// --- where nothing is seen (tube_bridge.c)

// line->sigma grows where there are no points; *base: length without any at the base
status tube_bridge(const tube_fit *f, centreline *line, double *base);

// --- what else is told (tube_report.c)

// ERR_FILE where the base is not known and another tube is as good.
status tube_alone(const tube_grid *grid, const tube_trace *trace, const tube_options *options,
                  tube_window *window);

void tube_tell(const tube_fit *f, const centreline *line, tube_report *report);
