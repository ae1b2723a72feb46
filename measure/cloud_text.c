// measure/cloud_text.c
// Points as text: XYZ, CSV, PTS. Columns are parted by blanks, commas, semicolons or tabs; without
// a line of names the first three are x, y and z.
#include "measure/cloud_parts.h"

#include "io/key_names.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

enum {
    MOST_LINES = 200, // in front of the first row
    MOST_UNNAMED = 9, // columns without names: x y z, a normal, a colour
    MOST_COLUMNS = 256,
    MOST_NAME = 64,
};

static const key column_keys[] = {
    {.name = "x", .kind = KEY_REAL, .dimension = DIM_LENGTH},
    {.name = "y", .kind = KEY_REAL, .dimension = DIM_LENGTH},
    {.name = "z", .kind = KEY_REAL, .dimension = DIM_LENGTH},
};
static const key_table column_table = {.name = "cloud", .nkey = 3, .keys = column_keys};

typedef struct layout {
    char mark;  // that parts columns: ',', ';', '\t', or ' ' for blanks
    bool comma; // decimal commas
    int ncolumn;
    int column[3];    // of x, y and z
    bool named;       // a line of names was there
    const unit *unit; // of its names; NULL: none
    long names_line;
} layout;

static bool is_blank(char c)
{
    return c == ' ' || c == '\t';
}

static char mark_of(const char *line)
{
    return strchr(line, ';') ? ';' : strchr(line, '\t') ? '\t' : strchr(line, ',') ? ',' : ' ';
}

// behind the blanks and the one mark that end a cell
static const char *next_cell(const char *c, char mark)
{
    while (*c == ' ' || (*c == '\t' && mark != '\t')) {
        c++;
    }
    if (*c && *c == mark) {
        c++;
        while (*c == ' ') {
            c++;
        }
    }
    return c;
}

static const char *cell_end(const char *c, char mark)
{
    const char *quote = *c == '"' ? strchr(c + 1, '"') : NULL; // marks inside do not part
    c = quote ? quote : c;
    while (*c && *c != mark && (mark == ';' || mark == ',' || !is_blank(*c))) {
        c++;
    }
    return c;
}

static int count_cells(const char *line, char mark)
{
    int n = 0;
    for (const char *c = line; *c && n < MOST_COLUMNS; n++) {
        c = next_cell(cell_end(c, mark), mark);
    }
    return n;
}

static const char *first_cell(const char *line)
{
    while (is_blank(*line)) {
        line++;
    }
    return line;
}

static bool is_comment(const char *c)
{
    return c[0] == '#' || c[0] == '%' || (c[0] == '/' && c[1] == '/');
}

static bool ends_cell(char c, char mark)
{
    return c == 0 || c == mark || is_blank(c);
}

// a number, in quotes or not; nothing else in its cell
static bool read_cell(const char **at, const layout *l, double *value)
{
    const bool quoted = **at == '"';
    *at += quoted;
    if (!cloud_number(at, l->comma, value) || (quoted && **at != '"')) {
        return false;
    }
    *at += quoted;
    return ends_cell(**at, l->mark);
}

// x, y and z of a row; the cell that is no number, or NULL
static const char *row_fault(const char *line, const layout *l, double xyz[3])
{
    const char *c = line;
    for (int i = 0, found = 0; found < 3 && *c; i++) {
        for (int d = 0; d < 3; d++) {
            const char *at = c;
            if (l->column[d] != i) {
                continue;
            }
            if (!read_cell(&at, l, &xyz[d])) {
                return c;
            }
            found++;
        }
        c = next_cell(cell_end(c, l->mark), l->mark);
    }
    return NULL;
}

// the layout of a row whose x, y and z are in these columns; false where the line is no row
static bool guess_layout(const char *line, const int column[3], layout *out)
{
    double xyz[3];
    layout l = {.mark = mark_of(line), .column = {column[0], column[1], column[2]}};
    l.comma = l.mark == ';' || l.mark == '\t';
    l.ncolumn = count_cells(line, l.mark);
    *out = l;
    return l.ncolumn > 0 && !row_fault(line, &l, xyz);
}

// "x [mm]", "X (mm)", "\"x_mm\"" -> "x_mm"
static void plain_name(const char *from, const char *end, char name[MOST_NAME])
{
    size_t n = 0;
    for (const char *c = from; c < end && n < MOST_NAME - 1; c++) {
        if (*c == '[' || *c == '(') {
            while (n > 0 && (name[n - 1] == ' ' || name[n - 1] == '_')) {
                n--;
            }
            name[n++] = '_';
        } else if (!strchr("])\"'", *c)) {
            name[n++] = (char)tolower((unsigned char)*c);
        }
    }
    while (n > 0 && is_blank(name[n - 1])) {
        n--;
    }
    name[n] = 0;
}

// the end of a name, whose unit may stand behind a blank
static const char *name_end(const char *c, char mark)
{
    const char *end = cell_end(c, mark);
    const char *bracket = end + strspn(end, " ");
    if (mark == ' ' && (*bracket == '[' || *bracket == '(')) {
        end = bracket + strcspn(bracket, "])");
        end += *end != 0;
    }
    return end;
}

typedef struct names {
    int column[3];
    const unit *unit[3]; // NULL: without one
} names;

static void take_name(const char *name, int column, names *out)
{
    for (int d = 0; d < 3; d++) {
        const unit *u = NULL;
        const key *k = key_find(&column_table, name, &u);
        const bool bare = name[0] == 'x' + d && name[1] == 0;
        if (out->column[d] < 0 && (bare || k == &column_keys[d])) {
            out->column[d] = column;
            out->unit[d] = bare ? NULL : u;
        }
    }
}

// Whether the line names x, y and z.
static bool read_names(const char *line, names *out)
{
    char name[MOST_NAME];
    const char mark = mark_of(line);
    *out = (names){.column = {-1, -1, -1}};
    const char *c = line + strspn(line, "/#% \t");
    for (int i = 0; *c && i < MOST_COLUMNS; i++) {
        const char *end = name_end(c, mark);
        plain_name(c, end, name);
        take_name(name, i, out);
        c = next_cell(end, mark);
    }
    return out->column[0] >= 0 && out->column[1] >= 0 && out->column[2] >= 0;
}

static status use_names(const cloud_stream *s, const names *n, layout *l)
{
    for (int d = 0; d < 3; d++) {
        if (n->unit[d] != n->unit[0]) {
            return stream_fail(s, "x, y and z in different units");
        }
        if (n->column[d] >= l->ncolumn) {
            return stream_fail(s, "%d columns, fewer than names", l->ncolumn);
        }
    }
    l->named = true;
    l->unit = n->unit[0];
    return OK;
}

static status check_layout(const cloud_stream *s, const layout *l)
{
    if (l->ncolumn < 3) {
        return stream_fail(s, "%d column%s: a point takes x, y and z", l->ncolumn,
                           l->ncolumn == 1 ? "" : "s");
    }
    if (!l->named && l->ncolumn > MOST_UNNAMED) {
        return stream_fail(s,
                           "%d columns without names: which are x, y and z? name them in a first "
                           "line (x_mm, y_mm, z_mm, ...)",
                           l->ncolumn);
    }
    return OK;
}

// PTS: how many points there are, alone on the first line
static bool is_count(const char *line)
{
    return line[strspn(line, "0123456789 \t")] == 0;
}

// Lines up to the first row, which stays in *line.
static status find_rows(cloud_stream *s, layout *l, char **line)
{
    status st = OK;
    names found = {.column = {0, 1, 2}}, here;
    bool any = false;
    for (int i = 0; i < MOST_LINES; i++) {
        TRY(stream_line(s, line));
        if (!*line) {
            TRY(stream_fail(s, "it has no row of numbers"));
        }
        static const char byte_order_mark[] = "\xef\xbb\xbf";
        *line += s->line == 1 && strncmp(*line, byte_order_mark, 3) == 0 ? 3 : 0;
        const char *c = first_cell(*line);
        if (*c == 0) {
            continue;
        }
        if (!is_comment(c) && guess_layout(c, found.column, l) &&
            !(l->ncolumn == 1 && is_count(c) && i == 0)) {
            TRY(any ? use_names(s, &found, l) : OK);
            return check_layout(s, l);
        }
        if (read_names(c, &here)) {
            found = here;
            any = true;
        }
    }
    TRY(stream_fail(s, "no row of numbers in the first %d lines", MOST_LINES));

done:
    return st;
}

static status take_row(const cloud_stream *s, const char *line, const layout *l, cloud_builder *b)
{
    status st = OK;
    double xyz[3];
    const int ncell = count_cells(line, l->mark);
    if (ncell != l->ncolumn) {
        TRY(stream_fail(s, "%d columns, but %d in the first row", ncell, l->ncolumn));
    }
    const char *fault = row_fault(line, l, xyz);
    if (fault) {
        const size_t length = (size_t)(cell_end(fault, l->mark) - fault);
        TRY(length == 0
                ? stream_fail(s, "a cell is empty")
                : stream_fail(s, "'%.*s' is no number", length < 40 ? (int)length : 40, fault));
    }
    TRY(b->cloud.count == b->room ? builder_grow(b, s) : OK);
    builder_put(b, xyz);

done:
    return st;
}

static status set_unit(const cloud_stream *s, double asked, const layout *l, cloud_builder *b)
{
    if (l->unit) {
        b->unit = l->unit->factor;
        if (!isnan(asked) && fabs(asked - b->unit) > 1e-9 * asked) {
            return status_fail(ERR_INPUT,
                               "%s: its columns are in %s; leave scan.unit out or say the same",
                               s->path, l->unit->name);
        }
    }
    return OK;
}

status cloud_text(cloud_stream *s, double unit, cloud_builder *b, cloud_report *report)
{
    status st = OK;
    layout l = {0};
    char *line = NULL;
    TRY(find_rows(s, &l, &line));
    TRY(set_unit(s, unit, &l, b));
    (void)snprintf(report->kind, sizeof report->kind, "text, %d columns%s", l.ncolumn,
                   l.named ? " with names" : "");
    report->unit_named = l.unit != NULL;
    while (line) {
        const char *c = first_cell(line);
        if (*c && !is_comment(c)) {
            TRY(take_row(s, c, &l, b));
        }
        TRY(stream_line(s, &line));
    }

done:
    return st;
}
