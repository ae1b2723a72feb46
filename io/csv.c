// io/csv.c
#include "io/csv.h"

#include "base/memory.h"
#include "io/disk.h"
#include "io/number.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

struct csv {
    FILE *stream;
    int ncolumn, column;
    char path[DISK_MAX_PATH];
};

static void begin_cell(csv *c)
{
    if (c->column > 0) {
        (void)fputc(',', c->stream);
    }
}

static void end_cell(csv *c)
{
    c->column++;
    if (c->column == c->ncolumn) {
        (void)fputs("\r\n", c->stream);
        c->column = 0;
    }
}

void csv_remark(csv *c, const char *words)
{
    (void)fprintf(c->stream, "# %s\r\n", words);
}

void csv_real(csv *c, double value)
{
    // what is not a number is an empty cell
    char text[NUMBER_TEXT] = "";
    if (isfinite(value)) {
        number_text(value, text);
    }
    begin_cell(c);
    (void)fputs(text, c->stream);
    end_cell(c);
}

void csv_text(csv *c, const char *value)
{
    // a spreadsheet takes a cell with one of these in front for a formula; a quote mark makes it a
    // text
    const bool formula = value[0] != '\0' && value[1] != '\0' && strchr("=+-@\t\r", value[0]);
    const bool quoted = strpbrk(value, ",\"\r\n") || value[0] == ' ';
    begin_cell(c);
    if (quoted) {
        (void)fputc('"', c->stream);
    }
    if (formula) {
        (void)fputc('\'', c->stream);
    }
    for (const char *p = value; *p; p++) {
        if (*p == '"') {
            (void)fputc('"', c->stream);
        }
        (void)fputc(*p, c->stream);
    }
    if (quoted) {
        (void)fputc('"', c->stream);
    }
    end_cell(c);
}

status csv_open(const char *path, int ncolumn, const char *const *names, csv **out)
{
    status st = OK;
    csv *c = NULL;
    TRY(TAKE(c, 1));
    c->ncolumn = ncolumn;
    TRY(disk_join(c->path, sizeof c->path, "%s", path));
    c->stream = fopen(path, "w");
    if (!c->stream) {
        TRY(disk_fail(path, "write"));
    }
    for (int i = 0; i < ncolumn; i++) {
        csv_text(c, names[i]);
    }
    *out = c;
    c = NULL;

done:
    free(c);
    return st;
}

status csv_close(csv *c)
{
    status st = OK;
    if (!c) {
        return OK;
    }
    const bool written = fflush(c->stream) == 0 && !ferror(c->stream);
    const bool closed = fclose(c->stream) == 0;
    if (!written || !closed) {
        st = disk_fail(c->path, "write");
    } else if (c->column != 0) {
        st = status_fail(ERR_BUG, "%s: a row ends after %d of %d cells", c->path, c->column,
                         c->ncolumn);
    }
    free(c);
    return st;
}
