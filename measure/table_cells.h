// measure/table_cells.h
// Inside of the reader of tables: a line's cells, numbers and names in them.
#pragma once

#include "measure/table.h"

typedef struct cell {
    const char *at; // without blanks and quote marks around
    int count;
} cell;

enum { CELLS_TOO_MANY = -1, CELLS_OPEN_QUOTE = -2 };

// The cells of a line before its comment; mark: what parts them,
// ' ' for any number of blanks and tabs.
int cells_split(const char *line, size_t length, char mark, cell out[TABLE_COLUMNS]);

typedef enum cell_kind { CELL_MISSING, CELL_NUMBER, CELL_NAN, CELL_TEXT } cell_kind;

// decimal: '.' or ',' where the number has one, else 0
cell_kind cell_read(cell c, char mark, double *value, char *decimal);

// "Force [N]", "force_N", "Force, N", "Force / N", "Force in N" -> "force", "N"
void cell_name(cell c, table_column *out);
// Whether the cell holds a unit and nothing else: "(mm)", "[-]", "kN".
bool cell_unit(cell c, char unit[TABLE_UNIT]);

// Whether `name` is one of "a|b|c".
bool cell_one_of(const char *name, const char *names);
