// base/input_file.h
// A file that a case names, read whole before anything looks at it: only a regular file, only up to
// a size, never waited for.
#pragma once

#include "base/key.h"
#include "base/status.h"

typedef struct input_file {
    char *path;           // as it was opened, for messages
    unsigned char *bytes; // [count + 1], the last one 0
    size_t count;
} input_file;

// A relative name starts from `directory`; NULL: the current one. ERR_FILE, with the place of the
// name, where it cannot be read, is no regular file or has more than `most` bytes.
status input_file_read(const char *directory, const key_text *name, size_t most, input_file *out);
// The same of a file that another process may be writing on: what it had when it was opened.
status input_file_read_so_far(const char *directory, const key_text *name, size_t most,
                              input_file *out);
void input_file_free(input_file *f);

// ERR_FILE "FILE:LINE: words"; without the line where it is 0.
status input_file_fail(const input_file *f, long line, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

// Whether the file begins, or but for blanks ends, with these words.
bool input_file_begins(const input_file *f, const char *words);
bool input_file_ends(const input_file *f, const char *words);
