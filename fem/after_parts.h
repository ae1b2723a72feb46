// fem/after_parts.h
// What the files of after.h share.
#pragma once

#include "fem/after.h"
#include "fem/after_line.h"

// The heights of the run, with the body's layers where they are its levels.
after_line after_line_of(const after *a);

// The section at any height, whichever levels this rank holds.
status after_pose_at(const body *b, double s, section_pose *out);

// F of the middle from its energy: a->F. docs/theory.md (5.5)
status after_find_law(after *a);

// Columns: what a unit wrench at one place, in its axes, is at another in the axes there; moments
// and lengths in units of `unit` [m].
mat6 after_transport(const section_pose *from, const section_pose *to, double unit);
// Both halves of a wrench or a twist turned: R n, R m.
vec6 vec6_turned(mat3 R, vec6 w);

// x of A x = b by rows, n at most 21; false where A is singular to rounding.
enum { AFTER_MOST_UNKNOWNS = 21 };
bool after_solve(int n, double (*A)[AFTER_MOST_UNKNOWNS], double *b);
