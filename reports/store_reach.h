// reports/store_reach.h
// What the files of a reach study's passage share.
#pragma once

#include "reports/store_parts.h"

#define JOINT_UNITS "m, rad, then N or rad (insertion, turn, tensions or bend)"
#define VERDICTS "0 reached, 1 out of reach, 2 joint limit, 3 collision, 4 no way in, 5 failed"

// n texts of `stride` bytes as GROUP/TAIL, one to a line; line ends within become spaces.
status store_pass_lines(const passage *p, const char *group, const char *tail, int n, void *text,
                        size_t stride);

// reports/store_reach_answers.c: of a scope, for each target.
status store_pass_reach_answers(const passage *p, const char *group, int ntarget,
                                reach_scope_result *s);
// reports/store_reach_design.c: nothing where there is none.
status store_pass_reach_design(const passage *p, reach_design_result *d);
