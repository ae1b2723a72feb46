// base/mark.h
// Where something stands in a case file.
#pragma once

#include <stdbool.h>

// A place in the case file; line 0 means: not given, the defaults stand.
typedef struct mark {
    int line, column; // from 1
} mark;

static inline bool mark_given(mark m)
{
    return m.line > 0;
}
