// fem/line_modes.h
// Modes along a body: of int N' N'^T against int N N^T over its levels. docs/theory.md (5.14c)
#pragma once

#include "fem/body.h"

typedef struct line_modes {
    int count;
    double *V;     // [count][nlevel] modes, orthonormal in the first; zero at levels that are known
    double *theta; // [count] their second form
} line_modes;

// base, tip: the first and the last level move.
status line_modes_make(const body *b, bool base, bool tip, line_modes *out);
void line_modes_free(line_modes *m);
