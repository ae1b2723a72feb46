// app/tendon_path.c
#include "app/case_rod.h"

#include "base/input_file.h"
#include "base/memory.h"
#include "io/key_names.h"
#include "io/number.h"

#include <math.h>
#include <string.h>

enum {
    MOST_BYTES = 16 << 20,
    MOST_ROWS = 100000,
    MOST_COLUMNS = 64,
    MOST_CELL = 40,
};

static const key column_keys[] = {
    {.name = "s", .kind = KEY_REAL, .dimension = DIM_LENGTH},
    {.name = "x", .kind = KEY_REAL, .dimension = DIM_LENGTH},
    {.name = "y", .kind = KEY_REAL, .dimension = DIM_LENGTH},
};
static const key_table column_table = {.name = "path", .nkey = 3, .keys = column_keys};

typedef struct path_table {
    input_file file;
    const char *next; // what is not read yet
    long line;        // of it, from 1
    int ncolumn;      // 0: the header is still to come
    int column[3];    // of s, x and y
    const unit *unit[3];
    int nrow, room;
    double *rows;
} path_table;

static bool is_separator(char c)
{
    return c == ' ' || c == '\t' || c == ',' || c == ';';
}

// One line into cells: blanks alone, or one comma or semicolon with blanks around it, part two of
// them. -1: too many of them, or too long.
static int split(const char *line, size_t length, char (*cell)[MOST_CELL])
{
    int n = 0;
    size_t i = 0;
    while (i < length && (line[i] == ' ' || line[i] == '\t')) {
        i++;
    }
    while (i < length && line[i] != '#') {
        size_t k = 0;
        if (n == MOST_COLUMNS) {
            return -1;
        }
        while (i < length && !is_separator(line[i]) && line[i] != '#' && k < MOST_CELL - 1) {
            cell[n][k++] = line[i++];
        }
        cell[n++][k] = '\0';
        if (i < length && !is_separator(line[i]) && line[i] != '#') {
            return -1;
        }
        for (int marks = 0; i < length && is_separator(line[i]); i++) {
            marks += line[i] == ',' || line[i] == ';';
            if (marks > 1) {
                break; // an empty cell
            }
        }
    }
    return n;
}

static status read_header(path_table *t, int n, char (*cell)[MOST_CELL])
{
    bool found[3] = {false, false, false};
    for (int i = 0; i < n; i++) {
        const unit *u = NULL;
        const key *k = key_find(&column_table, cell[i], &u);
        const int which = k ? (int)(k - column_keys) : -1;
        if (k && found[which]) {
            return input_file_fail(&t->file, t->line, "two columns '%s'", k->name);
        }
        if (k) {
            found[which] = true;
            t->column[which] = i;
            t->unit[which] = u;
        }
    }
    for (int i = 0; i < 3; i++) {
        if (!found[i]) {
            return input_file_fail(&t->file, t->line,
                                   "no column '%s_mm' (or _m, _cm, _um) in the line of names",
                                   column_keys[i].name);
        }
    }
    t->ncolumn = n;
    return OK;
}

static status more_room(path_table *t)
{
    status st = OK;
    double *rows = NULL;
    if (t->nrow < t->room) {
        return OK;
    }
    if (t->nrow == MOST_ROWS) {
        return input_file_fail(&t->file, t->line, "more than %d rows", MOST_ROWS);
    }
    const int room = t->room > 0 ? 2 * t->room : 256;
    TRY(TAKE(rows, 3 * (size_t)room));
    if (t->nrow > 0) {
        memcpy(rows, t->rows, 3 * (size_t)t->nrow * sizeof *rows);
    }
    free(t->rows);
    t->rows = rows;
    t->room = room;

done:
    return st;
}

static status read_row(path_table *t, int n, char (*cell)[MOST_CELL])
{
    status st = OK;
    if (n != t->ncolumn) {
        return input_file_fail(&t->file, t->line, "%d columns, but %d names", n, t->ncolumn);
    }
    TRY(more_room(t));
    for (int i = 0; i < 3; i++) {
        const char *text = cell[t->column[i]];
        double value = 0;
        if (!number_read(text, &value) || !isfinite(value)) {
            TRY(input_file_fail(&t->file, t->line, "'%s' is not a number", text));
        }
        t->rows[3 * (size_t)t->nrow + (size_t)i] = unit_to_si(t->unit[i], value);
    }
    t->nrow++;

done:
    return st;
}

static status read_lines(path_table *t)
{
    status st = OK;
    char(*cell)[MOST_CELL] = NULL;
    TRY(TAKE(cell, MOST_COLUMNS));
    while (*t->next) {
        const size_t length = strcspn(t->next, "\r\n");
        const int n = split(t->next, length, cell);
        if (n < 0) {
            TRY(input_file_fail(&t->file, t->line, "this is no line of a table of numbers"));
        }
        if (n > 0) {
            TRY(t->ncolumn == 0 ? read_header(t, n, cell) : read_row(t, n, cell));
        }
        t->next += length;
        t->next += t->next[0] == '\r' && t->next[1] == '\n';
        t->next += *t->next != '\0';
        t->line++;
    }

done:
    free(cell);
    return st;
}

status tendon_path_read(const char *directory, const key_text *name, int *nrow, double **rows)
{
    static const char byte_order_mark[] = "\xef\xbb\xbf";
    status st = OK;
    path_table t = {.line = 1};
    TRY(input_file_read(directory, name, MOST_BYTES, &t.file));
    t.next = (const char *)t.file.bytes;
    t.next += strncmp(t.next, byte_order_mark, 3) == 0 ? 3 : 0;
    if (strlen((const char *)t.file.bytes) != t.file.count) {
        TRY(input_file_fail(&t.file, 0, "it is no text"));
    }
    TRY(read_lines(&t));
    if (t.nrow < 2) {
        TRY(input_file_fail(&t.file, 0, "%d rows: a path takes two or more", t.nrow));
    }
    *nrow = t.nrow;
    *rows = t.rows;
    t.rows = NULL;

done:
    free(t.rows);
    input_file_free(&t.file);
    return st;
}
