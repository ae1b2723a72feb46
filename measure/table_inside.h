// measure/table_inside.h
// Inside of the reader of tables: where it stands, and how it finds the line of names.
#pragma once

#include "measure/table_cells.h"

typedef struct text_line {
    const char *at;
    size_t length;
    const char *next;
    long number;
} text_line;

typedef struct table_reader {
    input_file file;
    table_limits limits;
    table t;
    char mark;      // what parts cells, ' ' for blanks
    text_line line; // at which it stands
    int room;       // rows of t.a
    char decimal;   // of the numbers so far; 0: none had one
    long decimal_line;
} table_reader;

text_line text_line_at(const char *at, long number);
bool text_line_next(text_line *l); // false at the end of the text
bool text_line_is_blank(const text_line *l);
bool text_line_is_comment(const text_line *l);

// How many of the cells are of that kind.
int cells_of_kind(int n, const cell *c, char mark, cell_kind wanted);

// Whether the line is one of names with a row under it, whatever parts its cells: then the columns
// are set, and *row is the line of the first row.
bool table_names_fit(table_reader *r, const text_line *l, text_line *row);

// ERR_FILE: why no line of the text is one of names.
status table_explain(const table_reader *r, const char *text);
