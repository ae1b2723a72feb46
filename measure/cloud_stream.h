// measure/cloud_stream.h
// A regular file read forwards once, by lines or by bytes, through one buffer.
#pragma once

#include "base/status.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { STREAM_ROOM = 1 << 18 }; // bytes of the buffer: the longest line and the longest piece

typedef struct cloud_stream {
    int fd;
    char *path;
    uint64_t size;         // of the file
    uint64_t loaded;       // bytes of it that came into the buffer so far
    size_t begin, end;     // in the buffer: not taken yet
    unsigned char *buffer; // [STREAM_ROOM + 1]
    long line;             // the last one given, from 1; 0 where bytes are read
    void (*progress)(void *context, double share);
    void *context;
} cloud_stream;

// ERR_FILE where it cannot be opened, is empty or is no regular file.
status stream_open(const char *path, cloud_stream *out);
void stream_close(cloud_stream *s);

// What comes next without taking it: at most `most` bytes, fewer only at the end; a zero follows.
status stream_peek(cloud_stream *s, size_t most, const unsigned char **bytes, size_t *count);

// The next line without its end, a zero behind it; *line NULL at the end of the file. ERR_FILE for
// a line with a zero in it or longer than the buffer.
status stream_line(cloud_stream *s, char **line);
// The next line that is not blank: `row` (from 0) of `count` that were promised. ERR_FILE
// where the file ends before.
status stream_row(cloud_stream *s, uint64_t row, uint64_t count, char **line);

// The next `count` bytes. ERR_FILE where the file ends before.
status stream_bytes(cloud_stream *s, size_t count, const unsigned char **bytes);
status stream_skip(cloud_stream *s, uint64_t count);

uint64_t stream_place(const cloud_stream *s); // bytes taken
uint64_t stream_left(const cloud_stream *s);  // bytes to come, by the file's size

// From here on places are told in bytes.
void stream_in_bytes(cloud_stream *s);

// ERR_FILE with the file and the line, or the byte where lines are not counted.
status stream_fail(const cloud_stream *s, const char *format, ...)
    __attribute__((format(printf, 2, 3)));
