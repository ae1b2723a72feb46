// reports/markup.c
#include "reports/markup.h"

#include "io/utf8.h"

#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

status bytes_append(bytes *b, const char *data, size_t length)
{
    if (length >= SIZE_MAX / 4 || b->length >= SIZE_MAX / 4) {
        return status_fail(ERR_RESOURCE, "a text of the report grew too long");
    }
    if (b->length + length + 1 > b->room) {
        const size_t room = 2 * (b->length + length) + 256;
        char *grown = realloc(b->data, room);
        if (!grown) {
            return status_fail(ERR_RESOURCE, "out of memory for the report");
        }
        b->data = grown;
        b->room = room;
    }
    if (length > 0) {
        memcpy(b->data + b->length, data, length);
    }
    b->length += length;
    b->data[b->length] = 0;
    return OK;
}

status bytes_text(bytes *b, const char *text)
{
    return bytes_append(b, text, strlen(text));
}

status bytes_format(bytes *b, const char *format, ...)
{
    char text[2048];
    va_list arguments;
    va_start(arguments, format);
    const int n = vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    if (n < 0 || n >= (int)sizeof text) {
        return status_fail(ERR_BUG, "report: a piece of text is longer than its buffer");
    }
    return bytes_append(b, text, (size_t)n);
}

void bytes_free(bytes *b)
{
    free(b->data);
    *b = (bytes){0};
}

int utf8_length(const char *text, size_t left)
{
    uint32_t point = 0;
    return utf8_read(text, left, &point);
}

size_t utf8_clean(const char *text, char *out, size_t size)
{
    size_t left = strlen(text), used = 0, count = 0;
    while (left > 0) {
        uint32_t point = 0;
        const int n = utf8_read(text, left, &point);
        const size_t step = n > 0 ? (size_t)n : 1;
        if (used + step + 1 > size) {
            break;
        }
        if (n == 0 || !utf8_is_plain(point)) {
            out[used++] = n == 0 ? '?' : ' ';
        } else {
            memmove(out + used, text, step);
            used += step;
        }
        text += step;
        left -= step;
        count++;
    }
    out[used] = 0;
    return count;
}

void utf8_shorten(const char *text, size_t columns, char *out, size_t size)
{
    static const char ellipsis[] = "\xE2\x80\xA6";
    if (utf8_clean(text, out, size) <= columns || columns == 0) {
        return;
    }
    char *end = out;
    for (size_t i = 0; i + 1 < columns; i++) {
        end += utf8_length(end, strlen(end));
    }
    const size_t at = (size_t)(end - out);
    if (at + sizeof ellipsis <= size) {
        memcpy(end, ellipsis, sizeof ellipsis);
    } else {
        *end = 0;
    }
}

static const char *entity(char letter)
{
    switch (letter) {
    case '&':
        return "&amp;";
    case '<':
        return "&lt;";
    case '>':
        return "&gt;";
    case '"':
        return "&quot;";
    case '\'':
        return "&#39;";
    default:
        return NULL;
    }
}

status markup_escape(bytes *b, const char *text, size_t length)
{
    status st = OK;

    while (length > 0) {
        uint32_t point = 0;
        const int n = utf8_read(text, length, &point);
        const size_t step = n > 0 ? (size_t)n : 1;
        const char *word = n == 1 ? entity(*text) : NULL;
        const int blank = *text == '\n' || *text == '\t';
        if (word) {
            TRY(bytes_text(b, word));
        } else if (n == 0 || (!utf8_is_plain(point) && !blank)) {
            TRY(bytes_text(b, n == 0 ? "?" : " "));
        } else {
            TRY(bytes_append(b, text, step));
        }
        text += step;
        length -= step;
    }

done:
    return st;
}
