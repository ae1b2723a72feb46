// fem/rungs.h
// The ladder of meshes towards a tolerance: each rung takes about three times the work of the one
// below it and leaves a third to a quarter of its error. docs/theory.md (5.15)
#pragma once

#include "base/status.h"
#include "fem/load.h"

enum { RUNG_COUNT = 6 };

typedef struct segment_rung {
    int plane_order;
    double size;       // largest element of the section over its radius; 0: by the order
    double edge_first; // the first layer at free edges over the radius; 1: no layers
    int order;         // along s
    double end_first;  // the first layer at a clamped or capped end over the radius. Slabs of the
                       // doubling are no thicker
    double between;    // longest layer over the radius as far as end effects reach
} segment_rung;

// rung: 0..RUNG_COUNT - 1
segment_rung segment_rung_of(int rung);

typedef struct rung_body {
    double length, radius; // [m]
    int base, tip;         // segment_base, segment_tip
    int sections_along;    // layers are no longer than 1 / this of the length; 0: no matter
} rung_body;

// Where layers begin and end: they grow geometrically away from both ends and are long between.
// *layer [*nlayer + 1] is the caller's to free [m].
status segment_rung_layers(const segment_rung *r, const rung_body *b, int *nlayer, double **layer);

// What part of the error of the rung below is expected to be left on a rung >= 1, for Poisson's
// ratio nu and a kind of tip. And what the difference from the rung below is to be multiplied by
// for the error.
double segment_rung_left(int rung, double nu, int tip);
double segment_rung_factor(int rung, double nu, int tip);
double segment_rung_law_factor(int rung); // of the middle's law
// The largest that factor is where a sequence converges: on a rung that finds walls too thin for
// its layers.
double segment_rung_slowest(void);

// Estimate of the error of value[n - 1], on a rung, from the values of the n = 2 or 3 rungs up to
// it.
double segment_rung_error(int rung, double nu, int tip, int n, const double *value);
