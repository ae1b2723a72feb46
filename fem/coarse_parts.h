// fem/coarse_parts.h
// What the files of coarse.h share.
#pragma once

#include "fem/coarse.h"

enum { COARSE_RIGID = 6 };

struct coarse {
    coarse_spec spec;
    int count, size, band; // modes of a level; unknowns; of them in the band above the diagonal
    double *matrix;        // [size][band + 1], LAPACK's upper band
    double *right;         // [size] of one column
    // working storage of one level, for as many columns as there are modes
    double *rigid;          // [3 nplane][6]
    double *turned, *added; // [3 nplane][count]
    double *active;         // [count][count]
};

// a rigid cap has rigid motions only, a clamped base none
bool coarse_is_active(const coarse *c, int level, int mode);

// y [count][ncol] = modes of a level times r [3][nplane][ncol]; z += modes of a level times y
void coarse_restrict(coarse *c, int level, int ncol, const double *r, double *y);
void coarse_prolong(coarse *c, int level, int ncol, const double *y, double *z);

// (all) The matrix of the coarse space, before it is factored.
status coarse_fill(coarse *c);
