#include "meshes/png_door.h"

#include "base/memory.h"

#include <png.h>
#include <setjmp.h>
#include <stdio.h>
#include <string.h>

// what a hostile file may make libpng hold beside the image: text, profiles
enum { MOST_CHUNK_BYTES = 1 << 22, MOST_CHUNKS = 1000, SIGNATURE = 8 };

typedef struct reader {
    png_structp png;
    png_infop info;
    const unsigned char *bytes;
    size_t count, at;
    char words[120];
    colour_image image;
    png_bytep *row; // [height]
} reader;

// libpng's way back from an error: it must not return
static void on_error(png_structp png, png_const_charp words)
{
    reader *r = png_get_error_ptr(png);
    (void)snprintf(r->words, sizeof r->words, "%s", words);
    png_longjmp(png, 1);
}

static void on_warning(png_structp png, png_const_charp words)
{
    (void)png;
    (void)words;
}

static void give_bytes(png_structp png, png_bytep out, size_t count)
{
    reader *r = png_get_io_ptr(png);
    if (count > r->count - r->at) {
        r->at = r->count;
        png_error(png, "the file ends early");
    }
    memcpy(out, r->bytes + r->at, count);
    r->at += count;
}

// whatever the file holds becomes eight bits of red, green, blue and opacity
static void read_header(reader *r)
{
    png_set_user_limits(r->png, (png_uint_32)PNG_MOST_SIDE, (png_uint_32)PNG_MOST_SIDE);
    png_set_chunk_cache_max(r->png, MOST_CHUNKS);
    png_set_chunk_malloc_max(r->png, MOST_CHUNK_BYTES);
    png_set_read_fn(r->png, r, give_bytes);
    png_read_info(r->png, r->info);
    png_set_expand(r->png);
    png_set_scale_16(r->png);
    png_set_gray_to_rgb(r->png);
    png_set_add_alpha(r->png, 0xff, PNG_FILLER_AFTER);
    (void)png_set_interlace_handling(r->png);
    png_read_update_info(r->png, r->info);
    r->image.width = (int)png_get_image_width(r->png, r->info);
    r->image.height = (int)png_get_image_height(r->png, r->info);
    if (png_get_rowbytes(r->png, r->info) != 4 * (size_t)r->image.width) {
        png_error(r->png, "its colours cannot be brought to 8 bits");
    }
}

static void read_rows(reader *r)
{
    png_read_image(r->png, r->row);
    png_read_end(r->png, NULL);
}

// one step under libpng's error handling; false: r->words says why
static bool guarded(reader *r, void (*step)(reader *))
{
    if (setjmp(png_jmpbuf(r->png))) {
        return false;
    }
    step(r);
    return true;
}

static status damaged(const input_file *f, const reader *r)
{
    return input_file_fail(f, 0, "byte %zu: not a sound PNG image: %s", r->at, r->words);
}

static status take_rows(const input_file *f, reader *r)
{
    status st = OK;
    const size_t width = (size_t)r->image.width, height = (size_t)r->image.height;
    if (width * height > PNG_MOST_PIXELS) {
        TRY(input_file_fail(f, 0, "%zu x %zu pixels are too many, at most %d are read", width,
                            height, (int)PNG_MOST_PIXELS));
    }
    TRY(TAKE(r->image.rgba, 4 * width * height));
    TRY(TAKE(r->row, height));
    for (size_t j = 0; j < height; j++) {
        r->row[j] = r->image.rgba + 4 * width * j;
    }

done:
    return st;
}

void colour_image_free(colour_image *image)
{
    free(image->rgba);
    *image = (colour_image){0};
}

status png_door_read(const input_file *f, colour_image *out)
{
    status st = OK;
    reader r = {.bytes = f->bytes, .count = f->count};

    if (f->count < SIGNATURE || png_sig_cmp(f->bytes, 0, SIGNATURE) != 0) {
        return input_file_fail(f, 0, "not a PNG image: its first bytes are others");
    }
    r.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &r, on_error, on_warning);
    r.info = r.png ? png_create_info_struct(r.png) : NULL;
    if (!r.info) {
        TRY(status_fail(ERR_RESOURCE, "libpng cannot begin: out of memory, or another version"));
    }
    TRY(guarded(&r, read_header) ? OK : damaged(f, &r));
    TRY(take_rows(f, &r));
    TRY(guarded(&r, read_rows) ? OK : damaged(f, &r));
    *out = r.image;
    r.image = (colour_image){0};

done:
    png_destroy_read_struct(&r.png, &r.info, NULL);
    free(r.row);
    colour_image_free(&r.image);
    return st;
}
