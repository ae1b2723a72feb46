// measure/table.h
// A table of numbers from a file as people and machines write them: one line of names with units,
// then rows. Cells are parted by commas, semicolons, tabs or blanks; a decimal comma is understood
// where commas do not part; cells may be missing; # begins a comment; lines above the names are
// skipped where none of them is a row of numbers.
#pragma once

#include "base/input_file.h"
#include "base/key.h"

enum { TABLE_NAME = 64, TABLE_UNIT = 24, TABLE_COLUMNS = 64 };

typedef struct table_column {
    char name[TABLE_NAME]; // "force" of "Force [N]", "force_N", "force (N)"; small letters
    char unit[TABLE_UNIT]; // "N"; "" where none is given
} table_column;

typedef struct table {
    char *path; // for messages
    int ncolumn;
    table_column column[TABLE_COLUMNS];
    int nrow;
    double *a;  // [nrow][ncolumn] as written, in the columns' units; NAN: missing
    long *line; // [nrow] in the file, from 1
} table;

typedef struct table_limits {
    size_t bytes; // of the file
    int rows;
} table_limits;

// ERR_FILE "FILE:LINE: words" for what is no such table: no names, no rows, rows of other lengths,
// cells that are no numbers, infinities, more than the limits.
status table_read(const char *directory, const key_text *name, const table_limits *limits,
                  table *out);
void table_free(table *t);

// ERR_FILE "FILE:LINE: words"; row -1: of the whole file.
status table_fail(const table *t, int row, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

// The column of one of these names ("|" between them), -1 where there is none. With its unit's
// factor to SI: ERR_FILE where it has no unit, one of another dimension, or where two columns fit.
int table_find(const table *t, const char *names);
status table_column_si(const table *t, int column, dimension d, double *factor);

// [nrow] of one column in SI, owned by the caller.
status table_take(const table *t, int column, dimension d, double **out);
