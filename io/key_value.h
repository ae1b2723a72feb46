// io/key_value.h
// One value of a case, by its key: text to number (SI), choice, flag; each with its range.
#pragma once

#include "io/case_tree.h"
#include "io/key_names.h"

typedef struct value_key {
    const config *cfg;
    const key *k;
    const unit *u;
    const char *written;     // the key as it stands in the case
    const key_table *beside; // the table that knows it; NULL: none
} value_key;

// ERR_INPUT with the node's place, or the very character inside of it, for what is not the kind, or
// out of range.
status value_real(const value_key *v, const node *n, double *out);
status value_integer(const value_key *v, const node *n, int *out);
status value_flag(const value_key *v, const node *n, bool *out);
status value_text(const value_key *v, const node *n, const char **out);
status value_choice(const value_key *v, const node *n, int *out);
status value_field(const value_key *v, const node *n, field *out);
// Where x or y occurs the range is not checked: the places are not known here.
status value_place(const value_key *v, const node *n, place_field *out);
status value_vector(const value_key *v, const node *n, double *out); // k->count numbers
status value_fields(const value_key *v, const node *n, field *out);  // k->count of them
status value_rows(const value_key *v, const node *n, key_rows *out); // a flat list is one row

// ERR_INPUT: "'x_mm': expected `wanted`, found a list".
status value_mismatch(const value_key *v, const node *n, const char *wanted);

// ERR_INPUT where the key takes fewer entries.
status value_count(const value_key *v, const node *n, int count);
