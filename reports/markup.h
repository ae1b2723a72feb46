// reports/markup.h
// Text of a user's on its way into a page or a picture: UTF-8 checked, markup escaped; and a
// growing row of bytes.
#pragma once

#include "base/status.h"

#include <stddef.h>

typedef struct bytes {
    char *data; // data[length] = 0
    size_t length, room;
} bytes;

status bytes_append(bytes *b, const char *data, size_t length);
status bytes_text(bytes *b, const char *text);
status bytes_format(bytes *b, const char *format, ...) __attribute__((format(printf, 2, 3)));
void bytes_free(bytes *b);

// Number of bytes of the valid UTF-8 character at text (1..4), 0 where there is none.
int utf8_length(const char *text, size_t left);

// Copies text; bytes that are not UTF-8 become '?', what is not plain (io/utf8.h) a space; never
// cuts a character in two. `out` may be `text`. Returns the number of characters, which is the
// number of columns for the letters that this program writes.
size_t utf8_clean(const char *text, char *out, size_t size);

// As utf8_clean, in at most `columns` characters: the last one is an ellipsis where something was
// left off.
void utf8_shorten(const char *text, size_t columns, char *out, size_t size);

// Appends text for HTML or XML, both between tags and inside quotes; line ends and tabs stay.
status markup_escape(bytes *b, const char *text, size_t length);
