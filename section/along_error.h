// section/along_error.h
// How far the interpolant of the laws along a rod is off, relative.
#pragma once

#include "base/law_along.h"

// Between the nodes of one panel, by its last Chebyshev coefficients: K as in (6.1) and, where it
// is known, the mass over itself and its centre over the section's size.
double along_law_error(const law_along *along, int panel);

// Of the pattern's turn [rad]: a turn off by an angle puts K off by at most about that.
double along_turn_error(const law_along *along, int panel);

// The same measures at s against the law solved there, given in the frame turned by `turn`.
double along_miss(const law_along *along, double s, const beam_law *solved, double turn);
