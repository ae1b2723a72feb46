// base/chebyshev.h
// Interpolation on Chebyshev-Lobatto nodes t_i = -cos(pi i / (n - 1)), i = 0..n-1, of [-1, 1]; n =
// 1 is the constant.
#pragma once

enum { CHEBYSHEV_MAX_NODES = 33 };

double chebyshev_node(int n, int i);

// The n cardinal polynomials at t: p(t) = sum value[i] p(t_i), p'(t) = sum slope[i] p(t_i). slope
// may be NULL. The slopes come from the differentiation matrix, never from a difference of values:
// they stay accurate at the nodes.
void chebyshev_weights(int n, double t, double *value, double *slope);

// Coefficients of p in Chebyshev polynomials from its values at the n nodes [n]: their decay tells
// the interpolation's error.
void chebyshev_coefficients(int n, const double *at_node, double *coefficient);
