// reach/arc.h
// A tip of constant curvature: an arc of length L in the plane of x and z that leaves the origin
// along z and is bent by the angle `bend` towards +x (towards -x where it is negative).
#pragma once

#include "base/dense.h"

// The point at arclength s.
//   p(s) = (s^2 / L) bend ((1 - cos a) / a^2, 0, .) + (0, 0, s sin a / a),  a = bend s / L
vec3 arc_point(double length, double bend, double s);

// dp/dbend at arclength s; |dp/dbend| <= s^2 / (2 L).
vec3 arc_derivative(double length, double bend, double s);

// The bends within [low, high] whose end lies `rho` away from the axis, ascending: all of them, by
// the monotone pieces of (1 - cos a) / a between -2 pi and 2 pi. Returns how many.
enum { ARC_MOST_BENDS = 6 };
int arc_bends(double length, double rho, double low, double high, double bend[ARC_MOST_BENDS]);

// The bend in (0, 2 pi) at which the end is farthest from the axis, and how far of a unit length.
#define ARC_FARTHEST_BEND 2.331122370414422613667836
#define ARC_FARTHEST 0.724611353776708475
