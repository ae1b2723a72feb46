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
    PATH,   // a path follows: a hundredth of a point is enough
    PLACE,  // one coordinate follows
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
    {" x=\"", PLACE},
    {" y=\"", PLACE},
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

// cairo's pixels as mm on paper, up to `end`
static status write_size(const char *at, const char *end, double unit, bytes *out)
{
    status st = OK;
    while (at < end) {
        char *behind = NULL;
        const bool size = strncmp(at, "width=\"", 7) == 0 || strncmp(at, "height=\"", 8) == 0;
        const char *number = at + strcspn(at, "\"") + 1;
        const double pixels = size ? strtod(number, &behind) : 0;
        if (size && strncmp(behind, "px\"", 3) == 0) {
            TRY(bytes_append(out, at, (size_t)(number - at)));
            TRY(bytes_format(out, "%.8gmm", pixels * unit));
            at = behind + 2;
        } else {
            const size_t n = 1 + strcspn(at + 1, "wh>");
            TRY(bytes_append(out, at, n));
            at += n;
        }
    }

done:
    return st;
}

// The opening tag with its title. *from is moved behind it.
static status open_document(const char **from, const char *title, double unit, bytes *out)
{
    status st = OK;
    const char *start = svg_element(*from);
    const char *end = start ? strchr(start, '>') : NULL;
    if (!end) {
        return status_fail(ERR_BUG, "cairo wrote an SVG without an <svg> element");
    }

    TRY(bytes_append(out, *from, (size_t)(start - *from)));
    TRY(bytes_text(out, "<svg role=\"img\""));
    TRY(write_size(start + 4, end, unit, out));
    TRY(bytes_text(out, ">"));
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

static unsigned part_of(double percent)
{
    return isnan(percent) ? 0 : (unsigned)lround(fmin(fmax(percent, 0), 100) * 2.55);
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
    return bytes_format(out, "#%02x%02x%02x", part_of(part[0]), part_of(part[1]), part_of(part[2]));
}

// --- coordinates: to a hundredth of a point, each from the one before, nothing written that can be
// left off. Steps are differences of rounded places, so that no rounding adds up

typedef struct pen {
    bytes *out;
    long at[2], start[2]; // hundredths of a point: where the pen is, where the loop began
    bool bare;            // nothing need stand between what was written and a number
    bool point;           // the last number has a decimal point
} pen;

static status put_number(pen *p, long hundredths)
{
    status st = OK;
    char text[40], *from = text;
    (void)snprintf(text, sizeof text, "%.10g", (double)hundredths / 100);
    const bool minus = text[0] == '-';
    if (strncmp(text + minus, "0.", 2) == 0) {
        from = text + 1; // 0.5 is .5
        from[0] = minus ? '-' : from[0];
    }
    const bool apart = minus || p->bare || (from[0] == '.' && p->point);
    TRY(apart ? OK : bytes_text(p->out, " "));
    TRY(bytes_text(p->out, from));
    p->bare = false;
    p->point = strchr(from, '.') != NULL;

done:
    return st;
}

// far outside of any sheet, and small enough that steps do not overflow
static long hundredths_of(double points)
{
    static const double most = 1e9;
    return isnan(points) ? 0 : lround(fmin(fmax(points * 100, -most), most));
}

// the numbers of one command, pair by pair; a curve's three are all steps from where it begins
static status put_pairs(pen *p, char command, const char **at)
{
    status st = OK;
    for (int pair = 1;; pair++) {
        long x[2];
        for (int d = 0; d < 2; d++) {
            char *end = NULL;
            x[d] = hundredths_of(strtod(*at, &end));
            if (end == *at) {
                return OK;
            }
            *at = end;
            TRY(put_number(p, command == 'M' ? x[d] : x[d] - p->at[d]));
        }
        if (command != 'C' || pair % 3 == 0) {
            memcpy(p->at, x, sizeof x);
        }
        if (command == 'M') {
            memcpy(p->start, x, sizeof x);
        }
    }

done:
    return st;
}

// cairo ends every closed path by moving to where it began
static bool only_a_move_is_left(const char *p)
{
    return strncmp(p, " M ", 3) == 0 && p[3 + strspn(p + 3, "0123456789.- ")] == '"';
}

// cairo writes M, L, C and Z, all absolute; up to the closing quote
static status write_path(const char **at, bytes *out)
{
    status st = OK;
    const char *p = *at;
    pen pen = {.out = out};
    while (*p && *p != '"') {
        const char command = *p++;
        if (command == 'M' || command == 'L' || command == 'C') {
            TRY(bytes_text(out, command == 'M' ? "M" : command == 'L' ? "l" : "c"));
            pen.bare = true;
            TRY(put_pairs(&pen, command, &p));
        } else if (command == 'Z') {
            TRY(bytes_text(out, "z"));
            memcpy(pen.at, pen.start, sizeof pen.at);
            p += only_a_move_is_left(p) ? strcspn(p, "\"") : 0;
        }
    }
    *at = p;

done:
    return st;
}

// a lone coordinate
static status write_place(const char **at, bytes *out)
{
    status st = OK;
    char *end = NULL;
    pen pen = {.out = out, .bare = true};
    const double value = strtod(*at, &end);
    TRY(end > *at ? put_number(&pen, hundredths_of(value)) : OK);
    *at = end;

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
    case PLACE:
        return write_place(at, out);
    default:
        return OK;
    }
}

status svg_tidy(const bytes *raw, const char *name, const char *title, double unit, bytes *out)
{
    status st = OK;
    const char *at = raw->data ? raw->data : "";

    TRY(open_document(&at, title, unit, out));
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
        if (edits[i].action != DROP && edits[i].action != COLOUR) {
            TRY(bytes_append(out, at, n));
        }
        at += n;
        TRY(apply(edits[i].action, &at, name, out));
    }

done:
    return st;
}
