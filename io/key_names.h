// io/key_names.h
// Keys as a person writes them: name and unit, the unit's factor, and what to say when it is
// neither.
#pragma once

#include "io/case_tree.h"

enum {
    KEY_NAME_TEXT = 64,
    KEY_MAX_COUNT = 10000, // entries of a list whose key says nothing else (base/key.h)
};

typedef struct unit {
    const char *name; // "mm"; "" where the dimension is DIM_NONE
    double factor;    // to SI
} unit;

// The units of a dimension, the most usual one first; at least one.
int unit_list(dimension d, const unit **list);

// By division where the factor is one over a whole number, so that 3.6 mm is exactly the double
// next to 0.0036.
double unit_to_si(const unit *u, double value);
double unit_from_si(const unit *u, double value);

// "length" and "mm" -> "length_mm"
void key_spelling(const key *k, const unit *u, char name[KEY_NAME_TEXT]);

// The key that is written so, and its unit; NULL when there is none.
const key *key_find(const key_table *table, const char *written, const unit **u);

// "a_mm, a_m, a_cm, a_um"
void key_all_spellings(const key *k, char *words, size_t size);

// ERR_INPUT for an entry that key_find does not know: misspelled, without its unit, with a unit
// that is not known.
status key_unknown(const config *cfg, const key_table *table, const node *entry);

// Whether both are the same name with two units of one dimension ("length_mm", "length_m").
bool key_same_base(const char *a, const char *b);

// The tables that hang below one, each once, in the order in which they are met.
enum { KEY_MAX_TABLES = 64 };
typedef struct key_tables {
    int count;
    const key_table *item[KEY_MAX_TABLES];
} key_tables;

// ERR_BUG where there are more.
status key_tables_collect(const key_table *root, key_tables *out);
