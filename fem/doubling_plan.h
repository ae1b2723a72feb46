// fem/doubling_plan.h
// Which problems the doubling takes, in how many slabs, and what that costs (way_cost_doubling).
#pragma once

#include "fem/way.h"

// reported cuts halve the body this often, where it has that many slabs
enum { REPORTED_HALVINGS = 5 };

// ERR_INPUT: not a prism whose slabs are all the same, or not free between its ends.
status doubling_check(const segment_problem *p);

// ERR_INPUT with this reason.
status doubling_refuse(const char *why);

// How often slabs are joined: they are no thicker than the body's thinnest layer.
int doubling_count(const body *b);
