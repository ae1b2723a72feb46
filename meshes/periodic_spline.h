// meshes/periodic_spline.h
// The smooth closed curve through points: cubic pieces, continuous to the second derivative over
// the length of the chords.
#pragma once

#include "base/status.h"
#include "meshes/carrier.h"

// points: [n][2], n >= 3, neighbours differ, the last joins the first. piece: [n]. The error of a
// smooth curve falls with the fourth power of the points' distance.
status periodic_spline_make(int n, const double *points, carrier *piece);
