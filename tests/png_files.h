// PNG files as tests write them: no compression, no library. And images drawn by a rule.
#pragma once

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct png_bytes {
    unsigned char *at;
    size_t count;
} png_bytes;

static inline void png_put(png_bytes *b, const void *what, size_t count)
{
    memcpy(b->at + b->count, what, count);
    b->count += count;
}

static inline void png_put_number(png_bytes *b, uint32_t n)
{
    const unsigned char four[4] = {(unsigned char)(n >> 24), (unsigned char)(n >> 16),
                                   (unsigned char)(n >> 8), (unsigned char)n};
    png_put(b, four, 4);
}

static inline uint32_t png_crc(const unsigned char *at, size_t count)
{
    uint32_t crc = 0xffffffffu;
    for (size_t i = 0; i < count; i++) {
        crc ^= at[i];
        for (int k = 0; k < 8; k++) {
            crc = crc & 1 ? crc >> 1 ^ 0xedb88320u : crc >> 1;
        }
    }
    return ~crc;
}

static inline void png_put_chunk(png_bytes *b, const char *name, const void *data, size_t count)
{
    const size_t begin = b->count + 4;
    png_put_number(b, (uint32_t)count);
    png_put(b, name, 4);
    png_put(b, data, count);
    png_put_number(b, png_crc(b->at + begin, b->count - begin));
}

// Rows of raw samples, each behind a filter byte of 0, as stored blocks of deflate.
static inline void png_put_rows(png_bytes *b, const unsigned char *rows, size_t count)
{
    png_bytes z = {malloc(count + count / 65535 * 5 + 64), 0};
    uint32_t low = 1, high = 0;
    png_put(&z, "\x78\x01", 2);
    for (size_t at = 0; at < count;) {
        const size_t n = count - at > 65535 ? 65535 : count - at;
        const unsigned char head[5] = {at + n == count, (unsigned char)n, (unsigned char)(n >> 8),
                                       (unsigned char)~n, (unsigned char)(~n >> 8)};
        png_put(&z, head, 5);
        png_put(&z, rows + at, n);
        at += n;
    }
    for (size_t i = 0; i < count; i++) {
        low = (low + rows[i]) % 65521;
        high = (high + low) % 65521;
    }
    png_put_number(&z, high << 16 | low);
    png_put_chunk(b, "IDAT", z.at, z.count);
    free(z.at);
}

// depth: bits per sample; kind: 0 grey, 2 rgb, 3 palette, 4 grey and alpha, 6 rgba. palette: PLTE
// and tRNS contents or NULL. *out is the caller's to free.
typedef struct png_layout {
    int width, height, depth, kind, interlaced;
    const unsigned char *palette, *opacity;
    size_t npalette, nopacity;
} png_layout;

static inline png_bytes png_encode(const png_layout *l, const unsigned char *rows, size_t count)
{
    png_bytes b = {malloc(count + count / 65535 * 5 + 2000), 0}, head = {malloc(16), 0};
    const unsigned char rest[5] = {(unsigned char)l->depth, (unsigned char)l->kind, 0, 0,
                                   (unsigned char)l->interlaced};
    png_put(&b, "\x89PNG\r\n\x1a\n", 8);
    png_put_number(&head, (uint32_t)l->width);
    png_put_number(&head, (uint32_t)l->height);
    png_put(&head, rest, 5);
    png_put_chunk(&b, "IHDR", head.at, head.count);
    free(head.at);
    if (l->palette) {
        png_put_chunk(&b, "PLTE", l->palette, l->npalette);
    }
    if (l->opacity) {
        png_put_chunk(&b, "tRNS", l->opacity, l->nopacity);
    }
    png_put_rows(&b, rows, count);
    png_put_chunk(&b, "IEND", "", 0);
    return b;
}

// The image whose pixel has the palette's colour rule(x, y, context), at the pixel's centre, x to
// the right and y up, in pixels from the image's centre.
typedef int (*pixel_rule)(double x, double y, const void *context);

// colours of indices 0 (transparent), 1, 2, 3
static const unsigned char png_palette[12] = {0, 0, 0, 255, 0, 0, 0, 255, 0, 0, 0, 255};

static inline png_bytes png_draw(int width, int height, pixel_rule rule, const void *context)
{
    static const unsigned char opacity[1] = {0};
    const png_layout l = {.width = width,
                          .height = height,
                          .depth = 8,
                          .kind = 3,
                          .palette = png_palette,
                          .npalette = 12,
                          .opacity = opacity,
                          .nopacity = 1};
    const size_t stride = (size_t)width + 1, count = stride * (size_t)height;
    unsigned char *rows = calloc(count, 1);
    for (int j = 0; j < height; j++) {
        for (int i = 0; i < width; i++) {
            const double x = i + 0.5 - width / 2.0, y = height / 2.0 - j - 0.5;
            rows[(size_t)j * stride + (size_t)i + 1] = (unsigned char)rule(x, y, context);
        }
    }
    const png_bytes b = png_encode(&l, rows, count);
    free(rows);
    return b;
}

static inline int png_write(const char *path, png_bytes b)
{
    FILE *f = fopen(path, "wb");
    const int good = f && fwrite(b.at, 1, b.count, f) == b.count;
    return f && fclose(f) == 0 && good;
}
