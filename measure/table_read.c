// measure/table_read.c
// From the bytes of a file to a table: find the line of names, then take the rows below it.
#include "measure/table_inside.h"

#include "base/memory.h"

#include <math.h>
#include <string.h>

enum {
    USUAL_BYTES = 64 << 20,
    USUAL_ROWS = 1000000,
    USUAL_WORDS = 100,
    // a block with fewer rows above another one is part of the machine's preamble
    PREAMBLE_ROWS = 4,
};

static status more_room(table_reader *r)
{
    status st = OK;
    double *a = NULL;
    long *line = NULL;
    table *t = &r->t;
    const int most = r->limits.rows;
    if (t->nrow < r->room) {
        return OK;
    }
    if (t->nrow >= most) {
        return input_file_fail(&r->file, r->line.number, "more than %d rows", most);
    }
    const int twice = r->room == 0 ? 256 : 2 * r->room, room = twice < most ? twice : most;
    const size_t width = (size_t)t->ncolumn;
    TRY(TAKE(a, (size_t)room * width));
    TRY(TAKE(line, (size_t)room));
    if (t->nrow > 0) {
        memcpy(a, t->a, (size_t)t->nrow * width * sizeof *a);
        memcpy(line, t->line, (size_t)t->nrow * sizeof *line);
    }
    free(t->a);
    free(t->line);
    t->a = a;
    t->line = line;
    r->room = room;
    a = NULL;
    line = NULL;

done:
    free(a);
    free(line);
    return st;
}

// the place of a word in t->word
static status word_index(table_reader *r, cell c, double *out)
{
    table *t = &r->t;
    char word[TABLE_WORD];
    const int n = c.count < TABLE_WORD - 1 ? c.count : TABLE_WORD - 1;
    memcpy(word, c.at, (size_t)n);
    word[n] = '\0';
    int i = 0;
    while (i < t->nword && strcmp(t->word[i], word) != 0) {
        i++;
    }
    *out = i;
    if (i < t->nword) {
        return OK;
    }
    if (i == r->limits.words) {
        return input_file_fail(&r->file, r->line.number, "more than %d different words", i);
    }
    if ((i & (i - 1)) == 0) { // room for powers of two
        char(*more)[TABLE_WORD] = realloc(t->word, (i ? 2 * (size_t)i : 1) * sizeof *more);
        if (!more) {
            return status_fail(ERR_RESOURCE, "out of memory for the words of a table");
        }
        t->word = more;
    }
    memcpy(t->word[t->nword++], word, sizeof word);
    return OK;
}

static status take_number(table_reader *r, cell c, double *out)
{
    char decimal = 0;
    const cell_kind kind = cell_read(c, r->mark, out, &decimal);
    if (kind == CELL_TEXT || kind == CELL_NAN) {
        return input_file_fail(&r->file, r->line.number, "'%.*s' is not a number",
                               c.count < 40 ? c.count : 40, c.at);
    }
    if (decimal && r->decimal && decimal != r->decimal) {
        return input_file_fail(&r->file, r->line.number,
                               "'%.*s' has a decimal %s, and line %ld has a %s", c.count, c.at,
                               decimal == ',' ? "comma" : "point", r->decimal_line,
                               decimal == ',' ? "point" : "comma");
    }
    if (decimal && !r->decimal) {
        r->decimal = decimal;
        r->decimal_line = r->line.number;
    }
    return OK;
}

static status take_row(table_reader *r, int n, const cell *c)
{
    status st = OK;
    table *t = &r->t;
    if (n != t->ncolumn) {
        return input_file_fail(&r->file, r->line.number, "%d columns, but %d names", n, t->ncolumn);
    }
    TRY(more_room(r));
    double *row = t->a + (size_t)t->nrow * (size_t)t->ncolumn;
    for (int i = 0; i < t->ncolumn; i++) {
        row[i] = NAN;
        if (c[i].count > 0) {
            TRY(t->column[i].words ? word_index(r, c[i], &row[i]) : take_number(r, c[i], &row[i]));
        }
    }
    t->line[t->nrow++] = r->line.number;

done:
    return st;
}

// a line of the rows: *again where it begins another table, which the lines so far led to
static status read_line(table_reader *r, bool *again)
{
    cell c[TABLE_COLUMNS];
    const text_line *l = &r->line;
    int n = cells_split(l->at, l->length, r->mark, c);
    *again = false;
    if (n == CELLS_TOO_MANY) {
        return input_file_fail(&r->file, l->number, "more than %d columns", TABLE_COLUMNS);
    }
    if (n == CELLS_OPEN_QUOTE) {
        return input_file_fail(&r->file, l->number, "a quote mark is not closed");
    }
    while (n > r->t.ncolumn && c[n - 1].count == 0) {
        n--;
    }
    if (n > 0 && cells_of_kind(n, c, r->mark, CELL_NUMBER) == 0 &&
        cells_of_kind(n, c, r->mark, CELL_NAN) == 0 && r->t.nrow < PREAMBLE_ROWS) {
        *again = cells_of_kind(n, c, r->mark, CELL_TEXT) == n;
        if (*again) {
            return OK;
        }
    }
    return n > 0 ? take_row(r, n, c) : OK;
}

static void forget_rows(table_reader *r)
{
    table *t = &r->t;
    free(t->a);
    free(t->line);
    free(t->word);
    t->a = NULL;
    t->line = NULL;
    t->word = NULL;
    t->nrow = t->nword = r->room = 0;
    r->decimal = 0;
}

static status keep_head(table_reader *r, const char *text, const char *row)
{
    enum { MOST_HEAD = 64 << 10 };
    status st = OK;
    const size_t n = (size_t)(row - text) < MOST_HEAD ? (size_t)(row - text) : MOST_HEAD;
    free(r->t.head);
    r->t.head = NULL;
    TRY(TAKE(r->t.head, n + 1));
    memcpy(r->t.head, text, n);

done:
    return st;
}

// the rows of the table that begins at r->line; *again as above
static status read_rows(table_reader *r, bool *again)
{
    status st = OK;
    *again = false;
    do {
        if (!text_line_is_blank(&r->line) && !text_line_is_comment(&r->line)) {
            TRY(read_line(r, again));
        }
    } while (!*again && text_line_next(&r->line));

done:
    return st;
}

static status read_text(table_reader *r, const char *text)
{
    status st = OK;
    text_line l = text_line_at(text, 1), row;
    bool again = true;
    long stopped = 0; // the line that ended a block of few rows
    while (again) {
        while (!table_names_fit(r, &l, &row)) {
            if (!text_line_next(&l)) {
                return stopped > 0 ? input_file_fail(&r->file, stopped, "this is no row of numbers")
                                   : table_explain(r, text);
            }
        }
        forget_rows(r);
        r->line = row;
        TRY(keep_head(r, text, row.at));
        TRY(read_rows(r, &again));
        l = r->line;
        stopped = l.number;
    }

done:
    return st;
}

static status check_text(input_file *f)
{
    unsigned char *b = f->bytes;
    if (f->count > 0 && b[f->count - 1] == 0x1a) { // how DOS ends a text
        b[--f->count] = 0;
    }
    if (f->count >= 2 && ((b[0] == 0xff && b[1] == 0xfe) || (b[0] == 0xfe && b[1] == 0xff))) {
        return input_file_fail(f, 0, "it is in UTF-16: save it as UTF-8");
    }
    for (size_t i = 0; i < f->count; i++) {
        if (b[i] < 32 && !strchr("\t\n\r\f\v", b[i] ? b[i] : 1)) {
            return input_file_fail(f, 0, "it is no text: a table is read from CSV");
        }
    }
    return OK;
}

status table_read(const char *directory, const key_text *name, const table_limits *limits,
                  table *out)
{
    static const char byte_order_mark[] = "\xef\xbb\xbf";
    status st = OK;
    table_reader r = {.limits = limits ? *limits : (table_limits){0}};
    r.limits.bytes = r.limits.bytes ? r.limits.bytes : USUAL_BYTES;
    r.limits.rows = r.limits.rows ? r.limits.rows : USUAL_ROWS;
    r.limits.words = r.limits.words ? r.limits.words : USUAL_WORDS;
    TRY(input_file_read(directory, name, r.limits.bytes, &r.file));
    TRY(check_text(&r.file));
    TRY(read_text(&r, (const char *)r.file.bytes +
                          (input_file_begins(&r.file, byte_order_mark) ? 3 : 0)));
    r.t.path = r.file.path;
    r.file.path = NULL;
    *out = r.t;
    r.t = (table){0};

done:
    table_free(&r.t);
    input_file_free(&r.file);
    return st;
}
