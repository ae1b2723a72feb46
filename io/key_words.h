// io/key_words.h
// A key's value, range and default in plain words, for every form of the key reference.
#pragma once

#include "io/key_names.h"

#include <stdio.h>

enum { KEY_WORDS = 1024 };

// "number", "list of", "full|classical"; a kind that holds a table ends before the table's name.
void key_value_words(const key *k, char words[KEY_WORDS]);
// "0 to 0.5", "at least 1 mm"; "" where any value is allowed.
void key_limit_words(const key *k, char words[KEY_WORDS]);
// "required", "one of group 1", the default, or "".
void key_demand_words(const key *k, char words[KEY_WORDS]);
// What a key means, with its range in this unit and its default, for a comment beside it: "full
// angular width, more than 0 and less than 2 pi; 0 to 360 deg".
void key_help(const key *k, const unit *u, char words[KEY_WORDS]);

// A key reference: each table once, as `put_table` writes it.
status key_reference(const key_table *root, FILE *stream,
                     void (*put_table)(FILE *stream, const key_table *table));
