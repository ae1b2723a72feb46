// io/roff.c
#include "io/roff.h"

#include <ctype.h>
#include <stdbool.h>
#include <string.h>

// '-', '^', '~' and quotes have typographic meanings; the reader shall be able to copy what he sees
static const char *escaped(char c)
{
    switch (c) {
    case '\\':
        return "\\e";
    case '-':
        return "\\-";
    case '^':
        return "\\(ha";
    case '~':
        return "\\(ti";
    case '`':
        return "\\(ga";
    case '\'':
        return "\\(aq";
    case '"':
        return "\\(dq";
    case '|': // a line of choices may be broken there
        return "|\\:";
    default:
        return NULL;
    }
}

// wrap: 0, or the column after which the next space ends the input line
static void put(FILE *stream, const char *text, int wrap)
{
    int column = 0;
    for (const char *p = text; *p; p++) {
        // "\&" is nothing: a '.' behind it begins no request
        if (column == 0 && *p == '.') {
            (void)fputs("\\&", stream);
        }
        const char *instead = escaped(*p);
        const bool ends = *p == '\n' || (*p == ' ' && wrap && column > wrap);
        if (instead) {
            (void)fputs(instead, stream);
        } else {
            (void)fputc(ends ? '\n' : *p, stream);
        }
        column = ends ? 0 : column + (instead ? (int)strlen(instead) : 1);
    }
}

void roff_text(FILE *stream, const char *text)
{
    enum { COLUMN = 40 }; // lines go on with a word, and what stood before the text
    put(stream, text, COLUMN);
}

void roff_line(FILE *stream, const char *text)
{
    put(stream, text, 0);
}

void roff_title(FILE *stream, const char *name, int section, const char *version)
{
    (void)fputs(".TH ", stream);
    for (const char *p = name; *p; p++) {
        (void)fputc(toupper((unsigned char)*p), stream);
    }
    (void)fprintf(stream, " %d \"\" \"stiffaxis %s\"\n", section, version);
    (void)fputs(".\\\" no hyphens in names, nor gaps in lines\n.nh\n.ad l\n", stream);
}

void roff_heading(FILE *stream, const char *text)
{
    (void)fputs(".SH ", stream);
    for (const char *p = text; *p; p++) {
        (void)fputc(toupper((unsigned char)*p), stream);
    }
    (void)fputc('\n', stream);
}

void roff_item(FILE *stream, const char *term)
{
    (void)fputs(".TP\n\\fB", stream);
    roff_line(stream, term);
    (void)fputs("\\fR\n", stream);
}
