// rodsolver/tendon_table.h
// The path that a tendon's table of points stands for, fitted once per rod.
#pragma once

#include "base/spline.h"
#include "rodsolver/rod.h"

// Where the table's `smooth` is 0 the curve through the points: of degree 7, where that moves the
// cubic one by less than the cubic moves the straight lines between the points, else of degree 5 or
// 3. Where it is positive the simplest curve whose rms distance from them is at most
// smooth (1 + 1 / sqrt(count)): a constant, then polynomials, then ever more pieces of degree 7.
// ERR_INPUT, with the tendon's place, where the points are fewer than two, not finite, not in order
// or do not reach from the base to spec->end (> 0). No table: *out stays {0}.
status tendon_table_fit(const tendon_spec *spec, spline *out);

// Knots that cost the quadrature its order, ascending, for edges of panels; none where they are
// more than `most`: then they are so close that the panels' own estimates do.
int tendon_table_kinks(const spline *path, int most, double *s);
