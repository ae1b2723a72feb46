// base/field.h
// A number that may vary: a constant, or a function of the arclength s, or of the place x, y, s.
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

// A number that may vary over the section and along the rod: a constant, or a function of x, y and
// s [m]. Frozen at an arclength it varies over the section only.
typedef struct place_field {
    double value;                                                       // where it does not vary
    double (*at)(const void *expression, double x, double y, double s); // NULL where it does not
    const void *expression; // owned by the case that was read
    bool across, along;     // x or y occur in it; s does
    double s;               // where it is frozen
} place_field;

static inline double place_field_at(const place_field *f, double x, double y)
{
    return f->at ? f->at(f->expression, x, y, f->s) : f->value;
}
