#include "meshes/png_parts.h"

#include "base/memory.h"
#include "base/nearest.h"

#include <ctype.h>
#include <limits.h>
#include <string.h>

enum { HALF_OPAQUE = 128 };

void png_parts_free(png_parts *p)
{
    free(p->colour);
    *p = (png_parts){0};
}

static status fail_at(mark at, const char *words, const char *what, const char *more)
{
    return status_fail_at(ERR_INPUT, at.line, at.column, words, what, more);
}

static status read_colour(const part_spec *part, unsigned *rgb)
{
    const char *text = part->colour.text;
    if (!text) {
        return fail_at(part->at, "an image has colours, no names: write colour: '#rrggbb'%s%s", "",
                       "");
    }
    bool good = text[0] == '#' && strlen(text) == 7;
    for (int i = 1; good && i < 7; i++) {
        good = isxdigit((unsigned char)text[i]);
    }
    if (!good) {
        return fail_at(part->colour.at, "'%s' is no colour: six hexadecimal digits are, as in %s",
                       text, "'#ff8000'");
    }
    *rgb = (unsigned)strtoul(text + 1, NULL, 16);
    return OK;
}

static status find_material(const part_spec *part, const drawing_request *request, int *index)
{
    const char *name = part->material.text ? part->material.text : "";
    nearest near = nearest_to(name);
    char words[NEAREST_WORDS];
    *index = PIXEL_NONE;
    if (strcmp(name, "none") == 0) {
        return OK;
    }
    nearest_offer(&near, "none", "none");
    for (int i = 0; i < request->nmaterial && i < SHRT_MAX; i++) {
        nearest_offer(&near, request->materials[i].name, request->materials[i].name);
        if (strcmp(request->materials[i].name, name) == 0) {
            *index = i;
            return OK;
        }
    }
    return fail_at(part->material.at, "material '%s' is not defined%s", name,
                   nearest_words(&near, words));
}

static int colour_order(const void *a, const void *b)
{
    const png_colour *p = a, *q = b;
    return (p->rgb > q->rgb) - (p->rgb < q->rgb);
}

status png_parts_make(const png_spec *spec, const drawing_request *request, png_parts *out)
{
    status st = OK;
    png_parts p = {.count = spec->parts.count, .at = spec->at};
    const part_spec *part = spec->parts.items;

    if (p.count == 0) {
        TRY(fail_at(spec->at, "png: no `parts` say which colour is which material: %s%s",
                    "[{colour: '#ff0000', material: soft}]", ""));
    }
    TRY(TAKE(p.colour, (size_t)p.count));
    for (int i = 0; i < p.count; i++) {
        TRY(read_colour(&part[i], &p.colour[i].rgb));
        TRY(find_material(&part[i], request, &p.colour[i].material));
    }
    qsort(p.colour, (size_t)p.count, sizeof *p.colour, colour_order);
    for (int i = 1; i < p.count; i++) {
        if (p.colour[i].rgb == p.colour[i - 1].rgb) {
            TRY(status_fail_at(ERR_INPUT, p.at.line, p.at.column,
                               "png: colour #%06x has two entries in `parts`", p.colour[i].rgb));
        }
    }
    *out = p;
    p = (png_parts){0};

done:
    png_parts_free(&p);
    return st;
}

// --- a whole image

typedef struct strangers {
    int count, x, y; // the first one's column and row from the upper left, from 1
    unsigned rgb;
} strangers;

static status strangers_fail(const png_parts *p, const input_file *f, const strangers *s)
{
    return status_fail_at(ERR_INPUT, p->at.line, p->at.column,
                          "%s: colour #%06x, of the pixel in column %d of row %d from the top, is "
                          "not among the `parts`; %d pixel%s of such colours (were edges softened "
                          "when the image was made?)",
                          f->path, s->rgb, s->x, s->y, s->count, s->count > 1 ? "s are" : " is");
}

status png_parts_image(const png_parts *p, const input_file *f, const colour_image *image,
                       const double pitch[2], pixel_image *out)
{
    status st = OK;
    pixel_image px = {0};
    strangers s = {0};
    const png_colour *last = &p->colour[0];

    TRY(pixel_image_make(image->width, image->height, pitch, &px));
    for (int y = 0; y < image->height; y++) {
        short *row = px.at + (long)(image->height - 1 - y) * image->width;
        for (int x = 0; x < image->width; x++) {
            const unsigned char *c = image->rgba + 4 * ((long)y * image->width + x);
            if (c[3] < HALF_OPAQUE) {
                continue;
            }
            const png_colour wanted = {.rgb = (unsigned)(c[0] << 16 | c[1] << 8 | c[2])};
            const png_colour *found = wanted.rgb == last->rgb
                                          ? last
                                          : bsearch(&wanted, p->colour, (size_t)p->count,
                                                    sizeof *p->colour, colour_order);
            if (found) {
                row[x] = (short)found->material;
                last = found;
            } else if (s.count++ == 0) {
                s = (strangers){.count = 1, .x = x + 1, .y = y + 1, .rgb = wanted.rgb};
            }
        }
    }
    TRY(s.count > 0 ? strangers_fail(p, f, &s) : OK);
    *out = px;
    px = (pixel_image){0};

done:
    pixel_image_free(&px);
    return st;
}
