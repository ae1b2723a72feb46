// rodsolver/equilibrium_path.h
// The way from one equilibrium to the next: the pieces that natural steps, arclength and the search
// for critical points share.
#pragma once

#include "rodsolver/equilibrium.h"

// integral of v.v / L + L w.w over the rod, of two strain fields
double path_product(const equilibrium *e, const vec6 *a, const vec6 *b);

// e->xi, e->tension to e->old and back.
void path_keep(equilibrium *e);
void path_restore(equilibrium *e);
void path_factor(equilibrium *e, double factor);
void path_record(path *way, int kind, double fraction, int negative);

// Corrects at this factor; false where that fails or goes too far from what was predicted.
bool path_try(equilibrium *e, double factor, double tolerance, double predicted, double *moved);

// Whether the tangent changed its character between the kept point at way->factor and the present
// one: where, recorded as bifurcations. false: the step must be shorter to tell. e is left at the
// present point.
bool path_examine(equilibrium *e, path *way);

// By arclength from the kept point, at which natural steps got too short: past the limit point if
// there is one, PATH_LIMIT with e at it unless way->past. PATH_ARRIVED where natural steps may go
// on from e, or factor 1 is reached.
int path_turn(equilibrium *e, path *way, double tolerance);
