// rodsolver/routing.h
// Where a tendon runs in the section, and how fast that changes along the rod.
#pragma once

#include "rodsolver/rod.h"

// x, y [m] and dx, dy [-] (derivatives along s) of one tendon at one station.
typedef struct tendon_place {
    double x, y, dx, dy;
} tendon_place;

enum { ROUTING_NODES = 17 }; // far above the three stations a panel is integrated with

// A tendon's place over [a, b] by interpolation of x(s), y(s), so that the slopes are those of the
// interpolant.
typedef struct routing {
    double a, b;
    bool varies;
    double x[ROUTING_NODES], y[ROUTING_NODES];
} routing;

void routing_make(const tendon_spec *tendon, double a, double b, routing *out);
tendon_place routing_at(const routing *r, double s);

enum { ROUTING_MAX_KINKS = 16 };

// Arclengths, ascending, where the tendon's direction or its curvature jumps between the base and
// spec->end (> 0), at most ROUTING_MAX_KINKS: [ROUTING_MAX_KINKS] -> how many. Kinks nearer to each
// other than 1/64 of the end, or weaker than the path's own bending over that, may be missed.
int routing_kinks(const tendon_spec *spec, double *s);
