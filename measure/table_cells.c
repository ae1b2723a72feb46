// measure/table_cells.c
#include "measure/table_cells.h"

#include "io/number.h"
#include "measure/table_units.h"

#include <ctype.h>
#include <math.h>
#include <string.h>
#include <strings.h>

enum { NUMBER_MOST = 64 };

static bool is_blank(char c)
{
    return c == ' ' || c == '\t';
}

static cell trimmed(const char *at, const char *end)
{
    while (at < end && is_blank(*at)) {
        at++;
    }
    while (end > at && is_blank(end[-1])) {
        end--;
    }
    return (cell){at, (int)(end - at)};
}

// where the comment begins, or the end of the line
static const char *content_end(const char *line, size_t length)
{
    bool quoted = false;
    for (size_t i = 0; i < length; i++) {
        quoted = quoted != (line[i] == '"');
        if (line[i] == '#' && !quoted) {
            return line + i;
        }
    }
    return line + length;
}

static bool is_mark(char c, char mark)
{
    return mark == ' ' ? is_blank(c) : c == mark;
}

// the cell at *p, which moves to what parts it from the next one; false where a quote stays open
static bool take_cell(const char **p, const char *end, char mark, cell *out)
{
    const char *begin = *p, *q = begin;
    while (q < end && is_blank(*q) && !is_mark(*q, mark)) {
        q++;
    }
    if (q < end && *q == '"') {
        const char *close = memchr(q + 1, '"', (size_t)(end - q - 1));
        if (!close) {
            return false;
        }
        *out = trimmed(q + 1, close);
        for (q = close + 1; q < end && !is_mark(*q, mark); q++) {
            if (!is_blank(*q)) {
                return false;
            }
        }
    } else {
        while (q < end && !is_mark(*q, mark)) {
            q++;
        }
        *out = trimmed(begin, q);
    }
    *p = q;
    return true;
}

int cells_split(const char *line, size_t length, char mark, cell out[TABLE_COLUMNS])
{
    int n = 0;
    const char *end = content_end(line, length), *p = line;
    while (end > p && (end[-1] == ' ' || (mark == ' ' && end[-1] == '\t'))) {
        end--;
    }
    while (mark == ' ' && p < end && is_blank(*p)) {
        p++;
    }
    while (p < end) {
        cell c;
        if (!take_cell(&p, end, mark, &c)) {
            return CELLS_OPEN_QUOTE;
        }
        if (n == TABLE_COLUMNS) {
            return CELLS_TOO_MANY;
        }
        out[n++] = c;
        if (p < end && ++p == end && mark != ' ' && n < TABLE_COLUMNS) {
            out[n++] = (cell){p, 0};
        }
        while (mark == ' ' && p < end && is_blank(*p)) {
            p++;
        }
    }
    return n;
}

static bool is_word(cell c, const char *const *words)
{
    for (int i = 0; words[i]; i++) {
        if ((size_t)c.count == strlen(words[i]) &&
            strncasecmp(c.at, words[i], (size_t)c.count) == 0) {
            return true;
        }
    }
    return false;
}

cell_kind cell_read(cell c, char mark, double *value, char *decimal)
{
    static const char *const missing[] = {"", "-", "--", "n/a", "na", NULL};
    static const char *const nan_words[] = {"nan", "inf", "+inf", "-inf", "-nan", "infinity", NULL};
    char text[NUMBER_MOST];
    *decimal = 0;
    *value = NAN;
    if (is_word(c, missing)) {
        return CELL_MISSING;
    }
    if (is_word(c, nan_words)) {
        return CELL_NAN;
    }
    if (c.count >= NUMBER_MOST) {
        return CELL_TEXT;
    }
    memcpy(text, c.at, (size_t)c.count);
    text[c.count] = '\0';
    char *comma = strchr(text, ','), *point = strchr(text, '.');
    if (comma && (mark == ',' || point || strchr(comma + 1, ','))) {
        return CELL_TEXT;
    }
    *decimal = (char)(comma ? ',' : point ? '.' : 0);
    if (comma) {
        *comma = '.';
    }
    if (!number_read(text, value)) {
        return CELL_TEXT;
    }
    return isfinite(*value) ? CELL_NUMBER : CELL_NAN;
}

static void set_unit(cell c, char unit[TABLE_UNIT])
{
    const int n = c.count < TABLE_UNIT - 1 ? c.count : TABLE_UNIT - 1;
    memcpy(unit, c.at, (size_t)n);
    unit[n] = '\0';
}

// small letters, and one _ for what is neither letter nor digit
static void set_name(cell c, char name[TABLE_NAME])
{
    int n = 0;
    for (int i = 0; i < c.count && n < TABLE_NAME - 1; i++) {
        const unsigned char byte = (unsigned char)c.at[i];
        if (isalnum(byte) || byte >= 128) {
            name[n++] = (char)tolower(byte);
        } else if (n > 0 && name[n - 1] != '_') {
            name[n++] = '_';
        }
    }
    while (n > 0 && name[n - 1] == '_') {
        n--;
    }
    name[n] = '\0';
}

// "Force [N]": the brackets at the end; a round pair holds a unit only where it is known
static bool split_brackets(cell c, cell *name, cell *unit)
{
    const char last = c.count > 0 ? c.at[c.count - 1] : '\0', open = last == ']' ? '[' : '(';
    if (last != ']' && last != ')') {
        return false;
    }
    for (int i = c.count - 2; i > 0; i--) {
        if (c.at[i] == open) {
            table_unit known;
            *name = trimmed(c.at, c.at + i);
            *unit = trimmed(c.at + i + 1, c.at + c.count - 1);
            return open == '[' || table_unit_find(unit->at, (size_t)unit->count, &known);
        }
    }
    return false;
}

// "force_N", "Force, N", "Force / N", "Force N": the longest end that is a unit
static bool split_words(cell c, cell *name, cell *unit)
{
    for (int i = 1; i + 1 < c.count; i++) {
        table_unit known;
        const cell end = trimmed(c.at + i + 1, c.at + c.count);
        if (strchr("_,/ ", c.at[i]) && end.count > 0 &&
            table_unit_find(end.at, (size_t)end.count, &known) && known.d != DIM_COUNT) {
            *name = trimmed(c.at, c.at + i);
            *unit = end;
            return true;
        }
    }
    return false;
}

void cell_name(cell c, table_column *out)
{
    cell name = c, unit = {c.at, 0};
    *out = (table_column){0};
    if (!split_brackets(c, &name, &unit)) {
        (void)split_words(c, &name, &unit);
    }
    while (name.count > 0 && strchr("_,/ :=", name.at[name.count - 1])) {
        name.count--;
    }
    if (name.count > 3 && strncmp(name.at + name.count - 3, " in", 3) == 0) {
        name.count -= 3; // "Force in N"
    }
    set_name(name, out->name);
    set_unit(unit, out->unit);
}

bool cell_unit(cell c, char unit[TABLE_UNIT])
{
    table_unit known;
    const char first = c.count > 1 ? c.at[0] : '\0', last = first ? c.at[c.count - 1] : '\0';
    if ((first == '(' && last == ')') || (first == '[' && last == ']')) {
        c = trimmed(c.at + 1, c.at + c.count - 1);
    }
    set_unit(c, unit);
    return table_unit_find(c.at, (size_t)c.count, &known);
}

bool cell_one_of(const char *name, const char *names)
{
    const size_t n = strlen(name);
    while (names && *names) {
        const size_t k = strcspn(names, "|");
        if (k == n && strncasecmp(name, names, k) == 0) {
            return true;
        }
        names += k + (names[k] == '|');
    }
    return false;
}
