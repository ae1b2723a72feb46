// measure/table_note.c
// What the lines above a table say.
#include "measure/table_inside.h"
#include "measure/table_units.h"

#include <math.h>
#include <string.h>
#include <strings.h>

enum { MOST_WORDS = 4 };

// "area_mm2: 8" into "area_mm2" and what follows; what parts them is one of ":=;,\t"
static int split_note(const text_line *l, cell *c)
{
    const char *p = l->at + strspn(l->at, " \t#"), *end = l->at + l->length;
    const char *limit = ":=;\t";
    int n = 0;
    while (p < end && n < MOST_WORDS) {
        const char *q = p;
        while (q < end && !strchr(limit, *q)) {
            q++;
        }
        const char *from = p + strspn(p, " \""), *to = q;
        while (to > from && strchr(" \t\"", to[-1])) {
            to--;
        }
        if (to > from) {
            c[n++] = (cell){from, (int)(to - from)};
        }
        p = q + (q < end);
    }
    return n;
}

// "4,5 mm" and "4.5": the number at the front, the rest is a unit
static bool number_in_front(cell c, double *value, cell *rest)
{
    char decimal = 0;
    for (int n = c.count; n > 0; n--) {
        if (cell_read((cell){c.at, n}, ';', value, &decimal) == CELL_NUMBER) {
            const char *at = c.at + n, *end = c.at + c.count;
            while (at < end && *at == ' ') {
                at++;
            }
            *rest = (cell){at, (int)(end - at)};
            return true;
        }
    }
    return false;
}

static status read_note(const table *t, const text_line *l, int n, const cell *c, dimension d,
                        const table_column *name, double *value)
{
    char words[128];
    table_unit u;
    cell rest = {"", 0};
    const input_file file = {.path = t->path};
    if (n < 2 || !number_in_front(c[1], value, &rest)) {
        return input_file_fail(&file, l->number, "'%s' has no number", name->name);
    }
    if (rest.count == 0 && n > 2) {
        rest = c[2];
    }
    if (rest.count == 0) {
        rest = (cell){name->unit, (int)strlen(name->unit)};
    }
    table_unit_words(d, words, sizeof words);
    if (!table_unit_find(rest.at, (size_t)rest.count, &u) || u.d != d) {
        return input_file_fail(&file, l->number, "the unit of '%s' is '%.*s': it takes %s",
                               name->name, rest.count < 20 ? rest.count : 20, rest.at, words);
    }
    *value = table_unit_si(u, *value);
    return OK;
}

status table_note(const table *t, const char *names, dimension d, double *value, long *line)
{
    text_line l = text_line_at(t->head, 1);
    *line = 0;
    do {
        cell c[TABLE_COLUMNS];
        table_column name = {0};
        int n = split_note(&l, c);
        if (n == 1) { // "Area 8", "Area,8"
            const size_t skip = strspn(l.at, " \t#");
            n = cells_split(l.at + skip, l.length - skip, ',', c);
        }
        if (n > 0 && l.number != t->name_line) {
            cell_name(c[0], &name);
        }
        if (name.name[0] && cell_one_of(name.name, names)) {
            *line = l.number;
            return read_note(t, &l, n, c, d, &name, value);
        }
    } while (text_line_next(&l));
    return OK;
}

bool table_says(const table *t, const char *word)
{
    const size_t n = strlen(word);
    for (const char *p = t->head; *p; p++) {
        if (strncasecmp(p, word, n) == 0) {
            return true;
        }
    }
    return false;
}
