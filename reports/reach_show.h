// reports/reach_show.h
// A reach study in words: the same for the page, the tables, JSON and the terminal.
#pragma once

#include "reports/reach_result.h"

enum { REACH_WORDS = 256 };

// "insertion", "turn", "bend", "tension 1"
const char *reach_joint_words(const reach_scope_result *s, int joint, char *words, size_t room);
const char *reach_joint_unit(const reach_scope_result *s, int joint); // "m", "rad" or "N"

// Not reached, and no pose that is near has the clearance asked for: its bound says so.
bool reach_is_proved(const reach_result *r, const reach_answer *a);

// How thorough the search was that found no pose, "" where one was found.
const char *reach_search_words(const reach_result *r, const reach_scope_result *s,
                               const reach_answer *a, char *words, size_t room);

// What was asked of a pose: final poses only, or the way in too.
const char *reach_checked_words(const reach_result *r);

// Of all scopes the one that reaches most targets, then most area; -1: there is none.
int reach_best_scope(const reach_result *r);
