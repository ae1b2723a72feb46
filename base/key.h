// base/key.h
// Key tables: one table per map of the case file serves reading, checking, `schema` and the docs.
//
// A key's unit stands in its name: {.name = "length", .dimension = DIM_LENGTH} is written
// length_mm, length_m, ...; the value in the struct is always SI. A struct that a table fills
// begins with a `mark`.
#pragma once

#include "base/field.h"
#include "base/mark.h"

#include <stdbool.h>
#include <stddef.h>

typedef enum key_kind {
    KEY_REAL,    // double
    KEY_INTEGER, // int
    KEY_FLAG,    // bool: true or false
    KEY_TEXT,    // const char *, owned by the config
    KEY_NAME,    // key_text: a text with its place, a reference to something named elsewhere
    KEY_CHOICE,  // int: index into `choices`
    KEY_FIELD,   // field: a number or an expression in s
    KEY_PLACE,   // place_field: a number or an expression in x, y and s
    KEY_VECTOR,  // double[count]
    KEY_FIELDS,  // field[count]: a list of numbers or expressions in s
    KEY_ROWS,    // key_rows: a list of lists of `count` numbers (count 0: all rows as long as the
                 // first)
    KEY_TABLE,   // a struct in place, by `table`
    KEY_TEXTS,   // key_list of key_text: a yaml list of texts, or a single one
    KEY_LIST,    // key_list of structs by `table`; a yaml list
    KEY_NAMED,   // key_list of structs by `table`; a yaml map name -> entry; .name (const char *)
                 // follows the mark
} key_kind;

typedef enum dimension {
    DIM_NONE,
    DIM_LENGTH,            // _m _cm _mm _um
    DIM_ANGLE,             // _rad _deg
    DIM_FORCE,             // _N _mN
    DIM_MOMENT,            // _Nm _Nmm
    DIM_STRESS,            // _Pa _kPa _MPa _GPa
    DIM_DENSITY,           // _kg_per_m3 _g_per_cm3
    DIM_CURVATURE,         // _per_m _rad_per_m _deg_per_m _per_mm
    DIM_FORCE_PER_LENGTH,  // _N_per_m _N_per_mm _mN_per_mm
    DIM_MOMENT_PER_LENGTH, // _Nm_per_m _Nmm_per_mm _Nmm_per_m
    DIM_ACCELERATION,      // _m_per_s2
    DIM_FORCE_PER_VOLUME,  // _N_per_mm3 _N_per_m3; of an elastic foundation per area and length
    DIM_MOMENT_PER_ANGLE,  // _Nm_per_rad _Nmm_per_rad
    DIM_AREA,              // _mm2 _m2 _cm2
    DIM_COUNT,
} dimension;

typedef struct key_text {
    const char *text; // NULL: not given
    mark at;
} key_text;

typedef struct key_rows {
    mark at;
    int nrow, ncol;
    double *a; // [nrow][ncol], owned by the config
} key_rows;

typedef struct key_list {
    mark at;
    int count;
    void *items; // [count] structs of table->size bytes, owned by the config
} key_list;

typedef struct key_table key_table;

typedef struct key {
    const char *name; // without the unit
    key_kind kind;
    dimension dimension;
    double min, max; // SI, both included; not checked where both are 0
    int count;       // KEY_VECTOR, KEY_FIELDS, KEY_ROWS
    bool open;       // KEY_ROWS: an entry may be `~`, which is read as NAN
    int max_count;   // KEY_ROWS, KEY_TEXTS, KEY_LIST, KEY_NAMED: entries at most; 0 means 10000
    bool required;
    int one_of; // keys of a table with the same n > 0: exactly one is given; n < 0: at most one
    const char *choices; // KEY_CHOICE: "first|second|third"
    size_t offset;
    const key_table *table; // KEY_TABLE, KEY_LIST, KEY_NAMED
    const char *initial; // the default as a person writes it, for `schema` and the docs; the struct
                         // holds the value
    const char *about;
} key;

struct key_table {
    const char *name; // of the struct, for messages and the schema
    size_t size;      // sizeof the struct
    int nkey;
    const key *keys;
    const void *initial; // a struct of `size` bytes with the defaults; NULL: zeroes
    const char *about;
};
