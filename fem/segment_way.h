// fem/segment_way.h
// Which way a problem is solved: the case's, or the cheapest that the cost model knows.
#pragma once

#include "fem/way.h"

enum { SEGMENT_WHY_WORDS = 200 };

// Before body_make, under mpirun: the levels that this rank must hold, where that is not all.
void segment_share(body_spec *spec);

// The case's way, or the cheapest, and what it will take. why: what the choice was made by, in
// words; NULL: nobody asks.
int segment_way_choose(int asked, const segment_problem *p, way_cost *out, char *why);

// Memory that this process may have [byte].
double segment_memory(void);

// *taken: segment_way; why: what the choice was made by, in words.
status segment_way_solve(int asked, const segment_problem *p, const way_wants *wants, way_run *run,
                         int *taken, char why[SEGMENT_WHY_WORDS]);

const char *segment_way_name(int way);
