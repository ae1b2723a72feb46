// reports/reach_show.h
// A reach study in words: the same for the page, the tables, JSON and the terminal.
#pragma once

#include "reports/reach_result.h"

enum { REACH_WORDS = 256 };

// "insertion", "turn", "bend", "tension 1"
const char *reach_joint_words(const reach_scope_result *s, int joint, char *words, size_t room);
const char *reach_joint_unit(const reach_scope_result *s, int joint); // "m", "rad" or "N"

// Where a point of a shown body is: behind the entry point on its line, in the entry's channel, or
// where the wall is looked at.                                             docs/theory.md (10.14)
typedef enum reach_part { REACH_OUTSIDE, REACH_CHANNEL, REACH_LOOKED_AT } reach_part;
reach_part reach_part_of(const reach_result *r, const reach_answer *a, int point);
const char *reach_part_words(reach_part part); // "outside", "channel", "looked at"

// Not reached, and proved: no pose that is near has the clearance asked for, as its bound says; or
// no arc comes near, by more than what lies between the bends that were looked at.
bool reach_is_proved(const reach_result *r, const reach_scope_result *s, const reach_answer *a);

// The body was in the way wherever it was looked at, but no bound says that it always is.
bool reach_is_open(const reach_result *r, const reach_scope_result *s, const reach_answer *a);
int reach_open_count(const reach_result *r, const reach_scope_result *s);

// The verdict, "collision, not proved" where it is open.
const char *reach_told_words(const reach_result *r, const reach_scope_result *s,
                             const reach_answer *a);

// One bending joint at most can move.
bool reach_one_bend(const reach_scope_result *s);

// How thorough the search was that found no pose, "" where one was found.
const char *reach_search_words(const reach_result *r, const reach_scope_result *s,
                               const reach_answer *a, char *words, size_t room);

// What was asked of a pose: final poses only, or the way in too.
const char *reach_checked_words(const reach_result *r);

// Of all scopes the one that reaches most targets, then most area; -1: there is none.
int reach_best_scope(const reach_result *r);
