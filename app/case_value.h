// app/case_value.h
// What a case that was read holds under a key, named as --set names it, defaults included.
#pragma once

#include "app/case.h"

typedef struct case_value {
    const key *key;
    double number;    // in the unit of the spelling; NAN: not a number that is the same everywhere
    const char *text; // of a choice or a text; NULL otherwise; the caller copies it, first `length`
    int length;       // bytes
} case_value;

// ERR_INPUT at `at` where the case has no such key.
status case_value_find(const case_data *c, const char *path, mark at, case_value *out);
