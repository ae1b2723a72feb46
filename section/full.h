// section/full.h
// The warping and the generalized strains for six unit wrenches, prismatic or turning, and what
// becomes of them.
#pragma once

#include "section/section.h"
#include "section/warping.h"

typedef struct full_solution {
    int nnode;
    double *w; // [nnode][3][6]
    mat6 psi;  // column j for unit wrench j, psi_nx = psi_ny = 0
} full_solution;

void full_solution_free(full_solution *s);

// Of a pattern that does not turn: (3.3), (3.4).
status full_solve_prismatic(warping_problem *p, full_solution *s);

// Of one that does: (3.11)-(3.14).
status full_solve_turning(warping_problem *p, full_solution *s);

// X = E^-1 R, [KEPT][3 nnode], and the inverse of A - R^T X over the strains that are kept; the
// other rows and columns of S are zero. ERR_NUMERIC where it is not positive definite.
status full_condense(const warping_problem *p, const stiffness_factor *f, double *X, mat6 *S);

// w = -X psi of column j, from a psi without shears.
void full_set_column(const warping_problem *p, const double *X, int j, full_solution *s);

// (3.5) and (3.6), back to SI at the section's origin.
status full_law(warping_problem *p, const full_solution *s, beam_law *out);
status full_warping_in_si(const warping_problem *p, const full_solution *s, section_warping *out);
