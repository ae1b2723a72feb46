// base/field.h
// A number that may vary along the rod: a constant, or a function of the arclength s.
#pragma once

#include <stdbool.h>

typedef struct field {
    double value;                                   // where it does not vary
    double (*at)(const void *expression, double s); // NULL where it does not vary
    const void *expression;                         // owned by the case that was read
} field;

static inline field field_constant(double value)
{
    return (field){.value = value};
}

static inline bool field_varies(const field *f)
{
    return f->at != 0;
}

static inline double field_at(const field *f, double s)
{
    return f->at ? f->at(f->expression, s) : f->value;
}
