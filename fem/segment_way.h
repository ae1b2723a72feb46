// fem/segment_way.h
// Which way a problem is solved: the case's, or the cheapest that the cost model knows.
#pragma once

#include "fem/way.h"

enum { SEGMENT_WHY_WORDS = 200 };

// Shares the levels of the body, which is the problem's, out among the ranks where the way wants
// it. *taken: segment_way; why: what the choice was made by, in words.
status segment_way_solve(int asked, const segment_problem *p, const way_wants *wants, body *b,
                         way_run *run, int *taken, char why[SEGMENT_WHY_WORDS]);

const char *segment_way_name(int way);
