// fem/direct.h
// Ways with the matrix of the whole, which take any body and any supports.
#pragma once

#include "fem/way.h"

// multigrid: conjugate gradients in place of factors. docs/theory.md (5.13), (5.14e)
status direct_solve(const segment_problem *p, const way_wants *wants, bool multigrid, way_run *out);
