// rodsolver/kinks.h
// Where what varies along the rod is not smooth: edges of panels belong there.
#pragma once

#include "rodsolver/rod.h"

enum { MOST_KINKS = 16 };

// Arclengths, ascending, where the direction of the tendon's path or its curvature jumps between
// the base and spec->end (> 0): s [MOST_KINKS] -> how many. Of a table nothing is looked at: see
// tendon_table.h. Kinks nearer to each other than 1/64 of the end, or weaker than the path's own
// bending over that, may be missed.
int kinks_of_tendon(const tendon_spec *spec, double *s);

// The same where the value, its slope or its second derivative jumps between two arclengths.
int kinks_of_field(const field *f, double from, double to, double *s);
