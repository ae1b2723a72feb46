// meshes/msh_cursor.h
// Reads a MSH file's numbers and words one after another, as text or as bytes.
#pragma once

#include "base/input_file.h"

#include <stdint.h>

enum { MSH_NAME = 128 };

typedef struct msh_cursor {
    const input_file *file;
    const unsigned char *at, *end;
    long line;    // of `at`, from 1, as far as it was text
    bool binary;  // numbers are bytes from here on
    bool swapped; // with the other end first
} msh_cursor;

msh_cursor msh_cursor_at_start(const input_file *file);

// ERR_FILE with the line, or the byte's number within binary numbers.
status msh_fail(const msh_cursor *c, const char *format, ...) __attribute__((format(printf, 2, 3)));

// The next word between blanks; ERR_FILE where it is longer than the room or the file ends.
status msh_word(msh_cursor *c, char word[MSH_NAME]);

// "..." on this line.
status msh_quoted(msh_cursor *c, char name[MSH_NAME]);

void msh_skip_line(msh_cursor *c);

// Whether nothing but blanks is left.
bool msh_at_end(msh_cursor *c);

// A number; `what` names it in messages. int: 4 bytes of a binary file, size: 8.
status msh_int(msh_cursor *c, const char *what, int64_t *value);
status msh_size(msh_cursor *c, const char *what, int64_t *value);
status msh_real(msh_cursor *c, const char *what, double *value);

// A count of things that take at least so many bytes each: more than the file holds is refused.
// `wide`: a size, else an int.
status msh_count(msh_cursor *c, const char *what, bool wide, size_t text_bytes, size_t binary_bytes,
                 int *count);
