// rodsolver/routing.h
// Where a tendon runs in the section, and how fast that changes along the rod.
#pragma once

#include "base/spline.h"
#include "rodsolver/rod.h"

// x, y [m] and dx, dy [-] (derivatives along s) of one tendon at one station.
typedef struct tendon_place {
    double x, y, dx, dy;
} tendon_place;

enum { ROUTING_NODES = 17 }; // far above the three stations a panel is integrated with

// A tendon's place over [a, b]: x(s), y(s) of its fields by interpolation, so that the slopes are
// those of the interpolant, and its table's curve as it is.
typedef struct routing {
    double a, b;
    bool varies; // the fields do
    double x[ROUTING_NODES], y[ROUTING_NODES];
    const spline *table; // NULL: none
} routing;

// table: of tendon_table_fit; NULL or empty: none. It must outlive the routing.
void routing_make(const tendon_spec *tendon, const spline *table, double a, double b, routing *out);
tendon_place routing_at(const routing *r, double s);

// Place by the fields alone, and whether that varies.
void routing_place(const tendon_spec *tendon, double s, double *x, double *y);
bool routing_varies(const tendon_spec *tendon);
