// io/utf8.h
// UTF-8, one character at a time.
#pragma once

#include <stddef.h>
#include <stdint.h>

// Bytes of the valid character at `text` (1 to 4) of at most `length` bytes, its code point in
// *point; 0 where the bytes are not UTF-8 (overlong forms and surrogates included) or length is 0.
int utf8_read(const char *text, size_t length, uint32_t *point);

// Characters of a text that is UTF-8.
size_t utf8_count(const char *text);

// Whether a code point may stand in one line of a terminal: no control, no line or paragraph
// separator, no mark that changes the direction of writing.
int utf8_is_plain(uint32_t point);

// In place: '?' for what would break the line or play with the terminal, and for a character that
// was cut in two.
void utf8_make_plain(char *text);
