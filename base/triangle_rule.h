// base/triangle_rule.h
// Quadrature on the triangle (0,0) (1,0) (0,1).
#pragma once

enum { TRIANGLE_MAX_DEGREE = 40 };

// Points and weights of a rule exact to total degree `degree`, all of them inside and positive;
// returns how many, at most ((degree + 1) / 2 + 1)^2. Only point[][0] and [1] are written.
int triangle_rule(int degree, double (*point)[3], double *weight);
