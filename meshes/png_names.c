#include "meshes/png_names.h"

#include "base/memory.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

// A hole in the numbers is looked for this far behind the last file.
enum { LOOK_BEHIND = 10, MOST_WIDTH = 9 };

static status fail_at(const key_text *file, const char *words)
{
    return status_fail_at(ERR_INPUT, file->at.line, file->at.column, "png: '%s' %s", file->text,
                          words);
}

// finds %d, %3d or %03d and nothing else; the pattern itself is never given to printf
static status parse_pattern(png_names *n)
{
    const char *text = n->file.text, *at = strchr(text, '%');
    n->stack = at != NULL;
    if (!at) {
        return OK;
    }
    const char *c = at + 1;
    n->zeros = *c == '0';
    while (*c >= '0' && *c <= '9' && n->width <= MOST_WIDTH) {
        n->width = 10 * n->width + (*c++ - '0');
    }
    n->begin = (int)(at - text);
    n->end = (int)(c - text) + 1;
    if (*c != 'd' || n->width > MOST_WIDTH || strchr(c, '%')) {
        return fail_at(&n->file, "is no name of a stack: exactly one %d stands in it, or %03d for "
                                 "three digits, and no other %");
    }
    return OK;
}

static status name_of(const png_names *n, int number, char **out)
{
    status st = OK;
    const size_t size = strlen(n->file.text) + MOST_WIDTH + 16;
    TRY(TAKE(*out, size));
    if (!n->stack) {
        (void)snprintf(*out, size, "%s", n->file.text);
    } else if (n->zeros) {
        (void)snprintf(*out, size, "%.*s%0*d%s", n->begin, n->file.text, n->width, number,
                       n->file.text + n->end);
    } else {
        (void)snprintf(*out, size, "%.*s%*d%s", n->begin, n->file.text, n->width, number,
                       n->file.text + n->end);
    }

done:
    return st;
}

status png_names_at(const png_names *names, int i, char **out)
{
    return name_of(names, names->first + i, out);
}

static status exists(const png_names *n, const char *directory, int number, bool *there)
{
    status st = OK;
    char *name = NULL, *path = NULL;
    TRY(name_of(n, number, &name));
    const bool alone = name[0] == '/' || !directory || directory[0] == '\0';
    const size_t size = strlen(name) + (alone ? 0 : strlen(directory)) + 2;
    TRY(TAKE(path, size));
    (void)snprintf(path, size, "%s%s%s", alone ? "" : directory, alone ? "" : "/", name);
    *there = access(path, F_OK) == 0;

done:
    free(name);
    free(path);
    return st;
}

// ERR_INPUT where a later number is there although `number` is not
static status check_gap(const png_names *n, const char *directory, int number)
{
    status st = OK;
    char words[80];
    for (int k = 1; k <= LOOK_BEHIND; k++) {
        bool there = false;
        TRY(exists(n, directory, number + k, &there));
        if (there) {
            (void)snprintf(words, sizeof words, "has no slice %d, although there is a slice %d",
                           number, number + k);
            TRY(fail_at(&n->file, words));
        }
    }

done:
    return st;
}

static status count_slices(png_names *n, const char *directory)
{
    status st = OK;
    bool there = false;
    TRY(exists(n, directory, 0, &there));
    n->first = there ? 0 : 1;
    for (n->count = 0; n->count <= PNG_MOST_SLICES; n->count++) {
        TRY(exists(n, directory, n->first + n->count, &there));
        if (!there) {
            break;
        }
    }
    if (n->count == 0) {
        TRY(fail_at(&n->file, "has neither a slice 0 nor a slice 1: give `first` and `last`"));
    }
    TRY(check_gap(n, directory, n->first + n->count));

done:
    return st;
}

// what a shell takes for a stack; a name with a star in it may still be that of a file
static status check_star(const png_names *n, const char *directory)
{
    status st = OK;
    bool there = true;
    if (strchr(n->file.text, '*')) {
        TRY(exists(n, directory, 0, &there));
    }
    return there ? OK
                 : fail_at(&n->file, "names no file: write %d instead of * where the number of a "
                                     "slice stands, or %03d for three digits");

done:
    return st;
}

status png_names_find(const png_spec *spec, const char *directory, png_names *out)
{
    status st = OK;
    png_names n = {.file = spec->file, .count = 1};
    const bool range = spec->first > 0 || spec->last > 0;

    TRY(parse_pattern(&n));
    TRY(n.stack ? OK : check_star(&n, directory));
    if (!n.stack && (spec->layer > 0 || range)) {
        TRY(fail_at(&n.file, "is one image: a stack, which `layer`, `first` and `last` are for, "
                             "has a %d in its name"));
    }
    if (n.stack && !(spec->layer > 0)) {
        TRY(fail_at(&n.file, "is a stack: it needs the thickness of a slice, `layer_mm`"));
    }
    if (range && spec->last < spec->first) {
        TRY(fail_at(&n.file, "needs both `first` and `last`, in this order"));
    }
    if (range) {
        n.first = spec->first;
        n.count = spec->last - spec->first + 1;
    } else if (n.stack) {
        TRY(count_slices(&n, directory));
    }
    if (n.count > PNG_MOST_SLICES) {
        TRY(fail_at(&n.file, "has more than 100000 slices"));
    }
    *out = n;

done:
    return st;
}
