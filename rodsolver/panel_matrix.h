// rodsolver/panel_matrix.h
// The 9x9 problems of single panels, factored and solved in place.
#pragma once

#include "rodsolver/lie_step.h"

enum { PANEL_UNKNOWNS = 3 * GAUSS_STATIONS };

// L D L^T of the lower triangle, the pivots' reciprocals on the diagonal: the number of negative
// pivots, or -1 where one vanishes. product: times the size of all pivots.
int panel_factor_symmetric(double A[PANEL_UNKNOWNS][PANEL_UNKNOWNS], double *product);
void panel_solve_symmetric(const double A[PANEL_UNKNOWNS][PANEL_UNKNOWNS], double *b);
// For three columns at once.
void panel_solve_columns(const double A[PANEL_UNKNOWNS][PANEL_UNKNOWNS],
                         double b[PANEL_UNKNOWNS][3]);

// L U with row exchanges: the sign of the determinant, 0 where it vanishes.
int panel_factor_general(double A[PANEL_UNKNOWNS][PANEL_UNKNOWNS], int exchange[PANEL_UNKNOWNS],
                         double *product);
void panel_solve_general(const double A[PANEL_UNKNOWNS][PANEL_UNKNOWNS], const int *exchange,
                         double *b);
