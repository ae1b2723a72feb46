// base/field_table.h
// A number over x, y or s by a table: between the entries a monotone cubic (no over- or undershoot,
// one tangent at every entry), beyond them the first or the last value.
#pragma once

#include "base/field.h"
#include "base/key.h"
#include "base/status.h"

typedef enum table_axis { TABLE_ALONG_X, TABLE_ALONG_Y, TABLE_ALONG_S } table_axis;

typedef struct field_table {
    mark at;
    int along;       // table_axis
    key_rows places; // ascending [m]
    key_rows values; // as many
} field_table;

// ERR_INPUT with the table's place: fewer than two entries, not as many values as places, places
// that do not ascend.
status field_table_check(const field_table *t);

// The table as a field of the place; it points to the table, which stays the caller's.
place_field field_table_place(const field_table *t);
