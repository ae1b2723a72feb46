// measure/eigen.h
// Eigenvalues of small symmetric matrices, by Jacobi's rotations.
#pragma once

enum { EIGEN_MOST = 4 };

// a [n][n], n <= EIGEN_MOST; value ascending, vector[i] of value[i], of length 1.
void eigen_symmetric(int n, const double *a, double value[EIGEN_MOST],
                     double vector[EIGEN_MOST][EIGEN_MOST]);
