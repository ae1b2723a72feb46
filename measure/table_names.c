// measure/table_names.c
// Which line of a text holds the names of a table's columns.
#include "measure/table_inside.h"

#include <string.h>

static const char marks[] = "\t;, "; // in the order in which they are tried

bool text_line_is_blank(const text_line *l)
{
    return strspn(l->at, " \t,;") >= l->length;
}

bool text_line_is_comment(const text_line *l)
{
    return l->at[strspn(l->at, " \t")] == '#';
}

text_line text_line_at(const char *at, long number)
{
    const size_t length = strcspn(at, "\r\n");
    const char *next = at + length;
    next += next[0] == '\r' && next[1] == '\n';
    next += *next != '\0';
    return (text_line){at, length, next, number};
}

bool text_line_next(text_line *l)
{
    if (*l->next == '\0') {
        return false;
    }
    *l = text_line_at(l->next, l->number + 1);
    return true;
}

// past blank lines, and past comments where the line of names is none
static bool next_content(text_line *l, bool comments)
{
    bool more = text_line_next(l);
    while (more && (text_line_is_blank(l) || (text_line_is_comment(l) && !comments))) {
        more = text_line_next(l);
    }
    return more;
}

// names and units may stand behind a #
static int split_names(const text_line *l, char mark, cell out[TABLE_COLUMNS])
{
    const size_t skip = text_line_is_comment(l) ? strspn(l->at, " \t#") : 0;
    int n = cells_split(l->at + skip, l->length - skip, mark, out);
    while (n > 0 && out[n - 1].count == 0) {
        n--;
    }
    return n;
}

int cells_of_kind(int n, const cell *c, char mark, cell_kind wanted)
{
    int count = 0;
    for (int i = 0; i < n; i++) {
        double value = 0;
        char decimal = 0;
        count += cell_read(c[i], mark, &value, &decimal) == wanted;
    }
    return count;
}

// blanks part "Force [N]" too: its unit goes back to the name
static int join_units(int n, cell *c)
{
    int kept = 0;
    for (int i = 0; i < n; i++) {
        if (kept > 0 && c[i].count > 0 && strchr("([", c[i].at[0])) {
            c[kept - 1].count = (int)(c[i].at + c[i].count - c[kept - 1].at);
        } else {
            c[kept++] = c[i];
        }
    }
    return kept;
}

static bool are_names(int n, const cell *c, char mark)
{
    return n >= 2 && cells_of_kind(n, c, mark, CELL_NUMBER) == 0 &&
           cells_of_kind(n, c, mark, CELL_TEXT) > 0;
}

static bool are_units(int n, const cell *c)
{
    int known = 0;
    for (int i = 0; i < n; i++) {
        char unit[TABLE_UNIT], decimal = 0;
        double value = 0; // "1" is a unit too, but rather a number
        if (!cell_unit(c[i], unit) || cell_read(c[i], ';', &value, &decimal) == CELL_NUMBER) {
            return false;
        }
        known += unit[0] != '\0' && unit[0] != '-';
    }
    return known > 0;
}

static void set_columns(table_reader *r, int n, const cell *names, const cell *units, int nunit)
{
    r->t.ncolumn = n;
    for (int i = 0; i < n; i++) {
        table_column *c = &r->t.column[i];
        cell_name(names[i], c);
        if (i < nunit && c->unit[0] == '\0') {
            (void)cell_unit(units[i], c->unit);
        }
        c->words = cell_one_of(c->name, r->limits.word_columns);
    }
}

static bool is_row(const table_reader *r, int n, const cell *c)
{
    int numbers = 0;
    if (n < r->t.ncolumn) {
        return false;
    }
    for (int i = 0; i < n; i++) {
        double value = 0;
        char decimal = 0;
        const cell_kind kind = cell_read(c[i], r->mark, &value, &decimal);
        if (i >= r->t.ncolumn ? c[i].count > 0 : kind == CELL_TEXT && !r->t.column[i].words) {
            return false;
        }
        numbers += kind == CELL_NUMBER || kind == CELL_NAN;
    }
    return numbers > 0;
}

// Whether the line is one of names with a row under it, its cells parted by r->mark: then the
// columns are set, and *row is the line of the first row.
static bool names_fit(table_reader *r, const text_line *l, text_line *row)
{
    cell names[TABLE_COLUMNS], below[TABLE_COLUMNS];
    const bool comments = text_line_is_comment(l);
    int n = split_names(l, r->mark, names);
    n = r->mark == ' ' ? join_units(n, names) : n;
    text_line next = *l;
    if (n < 0 || !are_names(n, names, r->mark) || !next_content(&next, comments)) {
        return false;
    }
    int nbelow = split_names(&next, r->mark, below);
    if (nbelow > 0 && nbelow <= n && are_units(nbelow, below)) {
        set_columns(r, n, names, below, nbelow);
        if (!next_content(&next, comments)) {
            return false;
        }
    } else {
        set_columns(r, n, names, NULL, 0);
    }
    *row = next;
    nbelow = cells_split(next.at, next.length, r->mark, below);
    return nbelow > 0 && is_row(r, nbelow, below) && !text_line_is_comment(&next);
}

bool table_names_fit(table_reader *r, const text_line *l, text_line *row)
{
    for (const char *m = marks; *m; m++) {
        r->mark = *m;
        if (names_fit(r, l, row)) {
            r->t.name_line = l->number;
            return true;
        }
    }
    return false;
}

// --- what to say where there is no such line

static status explain_row(const table_reader *r, const text_line *l, const text_line *above,
                          char mark)
{
    cell names[TABLE_COLUMNS], cells[TABLE_COLUMNS];
    const int n = cells_split(l->at, l->length, mark, cells);
    const int nname = above->at ? cells_split(above->at, above->length, mark, names) : 0;
    if (nname <= 0) {
        return input_file_fail(&r->file, l->number, "numbers without a line of names above them");
    }
    if (n != nname) {
        return input_file_fail(&r->file, l->number, "%d columns, but %d names", n, nname);
    }
    for (int i = 0; i < n; i++) {
        double value = 0;
        char decimal = 0;
        if (cell_read(cells[i], mark, &value, &decimal) == CELL_TEXT) {
            return input_file_fail(&r->file, l->number, "'%.*s' is not a number",
                                   cells[i].count < 40 ? cells[i].count : 40, cells[i].at);
        }
    }
    return input_file_fail(&r->file, l->number, "no line of names stands above these numbers");
}

status table_explain(const table_reader *r, const char *text)
{
    text_line l = text_line_at(text, 1), above = {0};
    bool content = false;
    do {
        char best = 0;
        int most = 0;
        if (text_line_is_blank(&l) || text_line_is_comment(&l)) {
            continue;
        }
        content = true;
        for (const char *m = marks; *m; m++) {
            cell c[TABLE_COLUMNS];
            const int n = cells_split(l.at, l.length, *m, c);
            if (n == CELLS_TOO_MANY) {
                return input_file_fail(&r->file, l.number, "more than %d columns", TABLE_COLUMNS);
            }
            if (n > most && cells_of_kind(n, c, *m, CELL_NUMBER) > 0) {
                most = n;
                best = *m;
            }
        }
        if (best) {
            return explain_row(r, &l, &above, best);
        }
        above = l;
    } while (text_line_next(&l));
    return content ? input_file_fail(&r->file, 0, "no row of numbers under a line of names")
                   : input_file_fail(&r->file, 0, "it is empty");
}
