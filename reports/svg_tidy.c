// reports/svg_tidy.c
#include "reports/svg_tidy.h"

#include <ctype.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef enum action {
    DROP,   // a property at its initial value
    NAME,   // an id follows: the picture's name goes in front
    COLOUR, // three percentages follow: #rrggbb is a third as long
    PATH,   // coordinates follow: a hundredth of a point is enough
} action;

// cairo 1.16 writes every property of every path; none of its groups sets one of these to another
// value, except a text's group, which holds nothing but letters
static const struct {
    const char *word;
    action action;
} edits[] = {
    {" id=\"", NAME},
    {"url(#", NAME},
    {"href=\"#", NAME},
    {"rgb(", COLOUR},
    {" d=\"", PATH},
    {" x=\"", PATH},
    {" y=\"", PATH},
    {" stroke:none;fill-rule:nonzero;", DROP},
    {" stroke:none;", DROP},
    {"fill-opacity:1;", DROP},
    {"stroke-opacity:1;", DROP},
    {"stroke-linecap:butt;", DROP},
};

static const char surface_id[] = "surface";

const char *svg_element(const char *document)
{
    return strstr(document, "<svg");
}

// The opening tag with its title. *from is moved behind it.
static status open_document(const char **from, const char *title, bytes *out)
{
    status st = OK;
    const char *start = svg_element(*from);
    const char *end = start ? strchr(start, '>') : NULL;
    if (!end) {
        return status_fail(ERR_BUG, "cairo wrote an SVG without an <svg> element");
    }

    TRY(bytes_append(out, *from, (size_t)(start - *from)));
    TRY(bytes_text(out, "<svg role=\"img\""));
    TRY(bytes_append(out, start + 4, (size_t)(end + 1 - start - 4)));
    TRY(bytes_text(out, "\n<title>"));
    TRY(markup_escape(out, title, strlen(title)));
    TRY(bytes_text(out, "</title>"));
    *from = end + 1;

done:
    return st;
}

static status write_id(const char **at, const char *name, bytes *out)
{
    status st = OK;
    TRY(bytes_format(out, "%s-", name));
    // cairo numbers its surfaces through the whole process
    if (strncmp(*at, surface_id, sizeof surface_id - 1) == 0) {
        TRY(bytes_text(out, surface_id));
        *at += sizeof surface_id - 1;
        while (isdigit((unsigned char)**at)) {
            (*at)++;
        }
    }

done:
    return st;
}

static status write_colour(const char **at, bytes *out)
{
    double part[3] = {0};
    const char *p = *at;
    for (int i = 0; i < 3; i++) {
        char *end = NULL;
        part[i] = strtod(p, &end);
        p = end + strcspn(end, "0123456789)");
    }
    *at = p + (*p == ')');
    return bytes_format(out, "#%02x%02x%02x", (unsigned)lround(part[0] * 2.55),
                        (unsigned)lround(part[1] * 2.55), (unsigned)lround(part[2] * 2.55));
}

// cairo ends every closed path by moving to where it began
static bool only_a_move_is_left(const char *p)
{
    return strncmp(p, " M ", 3) == 0 && p[3 + strspn(p + 3, "0123456789.- ")] == '"';
}

// up to the closing quote
static status write_path(const char **at, bytes *out)
{
    status st = OK;
    const char *p = *at;

    while (*p && *p != '"') {
        if (isdigit((unsigned char)*p) || *p == '-') {
            char *end = NULL, number[40];
            const double value = round(strtod(p, &end) * 100) / 100;
            (void)snprintf(number, sizeof number, "%.8g", value == 0 ? 0.0 : value);
            TRY(bytes_text(out, number));
            p = end > p ? end : p + 1;
        } else {
            TRY(bytes_append(out, p, 1));
            p++;
            if (p[-1] == 'Z' && only_a_move_is_left(p)) {
                p += strcspn(p, "\"");
            }
        }
    }
    *at = p;

done:
    return st;
}

static status apply(action a, const char **at, const char *name, bytes *out)
{
    switch (a) {
    case NAME:
        return write_id(at, name, out);
    case COLOUR:
        return write_colour(at, out);
    case PATH:
        return write_path(at, out);
    default:
        return OK;
    }
}

status svg_tidy(const bytes *raw, const char *name, const char *title, bytes *out)
{
    status st = OK;
    const char *at = raw->data ? raw->data : "";

    TRY(open_document(&at, title, out));
    while (*at) {
        size_t i = 0, n = 0;
        for (; i < sizeof edits / sizeof *edits; i++) {
            n = strlen(edits[i].word);
            if (*at == *edits[i].word && strncmp(at, edits[i].word, n) == 0) {
                break;
            }
        }
        if (i == sizeof edits / sizeof *edits) {
            const size_t plain = 1 + strcspn(at + 1, " uhfsr");
            TRY(bytes_append(out, at, plain));
            at += plain;
            continue;
        }
        if (edits[i].action == NAME || edits[i].action == PATH) {
            TRY(bytes_append(out, at, n));
        }
        at += n;
        TRY(apply(edits[i].action, &at, name, out));
    }

done:
    return st;
}
