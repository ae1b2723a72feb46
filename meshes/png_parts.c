#include "meshes/png_parts.h"

#include "base/memory.h"
#include "meshes/parts.h"

#include <limits.h>

enum { HALF_OPAQUE = 128 };

void png_parts_free(png_parts *p)
{
    free(p->colour);
    *p = (png_parts){0};
}

static unsigned rgb_of(const unsigned char c[3])
{
    return (unsigned)c[0] << 16 | (unsigned)c[1] << 8 | c[2];
}

static int colour_order(const void *a, const void *b)
{
    const png_colour *p = a, *q = b;
    return (p->rgb > q->rgb) - (p->rgb < q->rgb);
}

status png_parts_make(const png_spec *spec, const drawing_request *request, png_parts *out)
{
    status st = OK;
    part_table table = {0};
    png_parts p = {.count = spec->parts.count, .at = spec->at};

    if (p.count == 0) {
        TRY(status_fail_at(ERR_INPUT, p.at.line, p.at.column,
                           "png: no `parts` say which colour is which material: [{colour: "
                           "'#ff0000', material: soft}]"));
    }
    TRY(parts_make("colour", &spec->parts, request, &table));
    TRY(TAKE(p.colour, (size_t)p.count));
    for (int i = 0; i < p.count; i++) {
        const part_spec *part = &table.spec[i];
        unsigned char c[3];
        if (!part->colour.text || !part_read_colour(part->colour.text, c)) {
            TRY(status_fail_at(ERR_INPUT, part->at.line, part->at.column,
                               "png: an image has colours, no names: write colour: '#rrggbb'"));
        }
        if (table.material[i] > SHRT_MAX) {
            TRY(status_fail_at(ERR_INPUT, part->at.line, part->at.column,
                               "png: more than %d materials", SHRT_MAX));
        }
        p.colour[i].rgb = rgb_of(c);
        p.colour[i].material = table.material[i] == PART_NONE ? PIXEL_NONE : table.material[i];
    }
    qsort(p.colour, (size_t)p.count, sizeof *p.colour, colour_order);
    *out = p;
    p = (png_parts){0};

done:
    parts_free(&table);
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
            const png_colour wanted = {.rgb = rgb_of(c)};
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
