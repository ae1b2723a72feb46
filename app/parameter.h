// app/parameter.h
// A parameter: one number that stands under one or several keys of a case. `fit` and `sensitivity`
// turn it; the key tables of both begin with PARAMETER_KEYS.
#pragma once

#include "base/key.h"
#include "base/status.h"

struct case_data;

typedef struct parameter {
    mark at;
    const char *name;
    key_list keys; // of key_text: dotted paths as --set takes them; all get the same value
} parameter;

enum { PARAMETER_MOST_KEYS = 64 };

// The rows of a key table for a struct that begins with a parameter.
#define PARAMETER_KEYS                                                                             \
    {.name = "name",                                                                               \
     .kind = KEY_TEXT,                                                                             \
     .required = true,                                                                             \
     .offset = offsetof(parameter, name),                                                          \
     .about = "what to call it in messages, tables and figures"},                                  \
    {                                                                                              \
        .name = "keys", .kind = KEY_TEXTS, .max_count = PARAMETER_MOST_KEYS, .required = true,     \
        .offset = offsetof(parameter, keys),                                                       \
        .about = "the keys that hold it, as --set names them (rod.tendons.t1.radius_mm): all get " \
                 "the same value, in the unit of their spelling"                                   \
    }

// No name, no key, keys with different units, a key twice: ERR_INPUT with its place.
status parameter_check(const struct case_data *c, const parameter *p);
// Two parameters of one name, or of one key.
status parameters_differ(const struct case_data *c, const parameter *p, const parameter *q);

// The unit of its keys' spelling, "" where they have none, and its factor to SI.
const char *parameter_unit(const parameter *p, double *factor);

// Settings KEY=VALUE of parameters, one after another, for a variation; from {0}.
typedef struct settings {
    int count, capacity;
    char **text;     // [count]
    char about[200]; // "tendon radius = 3.7, friction = 0.2", for messages
} settings;

status settings_add(settings *s, const parameter *p, double value); // in the keys' unit
status settings_add_text(settings *s, const parameter *p, const char *value);
void settings_free(settings *s);
