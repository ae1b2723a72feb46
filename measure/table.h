// measure/table.h
// A table of numbers from a file as people and machines write them: one line of names with units
// (or a second line with the units), then rows. Cells are parted by commas, semicolons, tabs or
// blanks, and may be quoted; a decimal comma is understood where commas do not part; cells may be
// missing; # begins a comment (and may stand before the names); lines above the names are skipped
// where none of them is a row of numbers.
#pragma once

#include "base/input_file.h"
#include "base/key.h"

enum { TABLE_NAME = 64, TABLE_UNIT = 24, TABLE_COLUMNS = 64, TABLE_WORD = 48 };

typedef struct table_column {
    char name[TABLE_NAME]; // "force" of "Force [N]", "force_N", "force (N)"; small letters
    char unit[TABLE_UNIT]; // "N"; "" where none is given
    bool words;            // its numbers are places in table.word
} table_column;

typedef struct table {
    char *path; // for messages
    int ncolumn;
    table_column column[TABLE_COLUMNS];
    int nrow;
    double *a;      // [nrow][ncolumn] as written, in the columns' units; NAN: missing
    long *line;     // [nrow] in the file, from 1
    long name_line; // that of the names
    char *head;     // the lines above the rows, for table_note and table_says
    int nword;
    char (*word)[TABLE_WORD]; // [nword] of the columns of words, each once
} table;

typedef struct table_limits {
    size_t bytes; // of the file; 0: 64 MiB
    int rows;     // 0: a million
    int words;    // of columns of words; 0: 1000
    // "specimen|sample": columns of these names hold words; NULL: none does
    const char *word_columns;
} table_limits;

// ERR_FILE "FILE:LINE: words" for what is no such table: no names, no rows, rows of other lengths,
// cells that are no numbers, infinities, more than the limits.
status table_read(const char *directory, const key_text *name, const table_limits *limits,
                  table *out);
void table_free(table *t);

// ERR_FILE "FILE:LINE: words"; row -1: of the whole file.
status table_fail(const table *t, int row, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
// The same of the line of names.
status table_fail_names(const table *t, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

// The first column of one of these names ("|" between them), -1 where there is none; from the
// column `from` on.
int table_find(const table *t, const char *names);
int table_find_next(const table *t, const char *names, int from);

// The same, where the table must have it: ERR_FILE where no column or more than one fits, or where
// its unit is missing or of another dimension.
status table_need(const table *t, const char *names, dimension d, int *column);

// Its unit's factor to SI: ERR_FILE where it has no unit (but for DIM_NONE), or one of another
// dimension.
status table_column_si(const table *t, int column, dimension d, double *factor);

// [nrow] of one column in SI, owned by the caller; NAN: missing.
status table_take(const table *t, int column, dimension d, double **out);

// What stands above the rows, as machines and people put it there: "Gauge length [mm];25",
// "# area_mm2: 8", "Width = 4 mm". *line is where it stands in the file, 0 where none of these
// names is there; ERR_FILE where one is without a number or its unit.
status table_note(const table *t, const char *names, dimension d, double *value, long *line);

// Whether the lines above the rows have this word, capital or small.
bool table_says(const table *t, const char *word);
