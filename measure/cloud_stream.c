// measure/cloud_stream.c
#include "measure/cloud_stream.h"

#include "base/input_file.h"
#include "base/memory.h"

#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

status stream_fail(const cloud_stream *s, const char *format, ...)
{
    char words[400];
    const input_file file = {.path = s->path};
    va_list args;
    va_start(args, format);
    (void)vsnprintf(words, sizeof words, format, args);
    va_end(args);
    if (s->line > 0 || stream_place(s) == 0) {
        return input_file_fail(&file, s->line, "%s", words);
    }
    return input_file_fail(&file, 0, "at byte %llu: %s", (unsigned long long)stream_place(s),
                           words);
}

static status check_file(cloud_stream *s)
{
    struct stat about;
    if (s->fd < 0 || fstat(s->fd, &about) != 0) {
        return stream_fail(s, "%s", strerror(errno));
    }
    if (!S_ISREG(about.st_mode)) {
        return stream_fail(s,
                           S_ISDIR(about.st_mode) ? "it is a directory" : "it is no regular file");
    }
    s->size = (uint64_t)about.st_size;
    return s->size > 0 ? OK : stream_fail(s, "it is empty");
}

status stream_open(const char *path, cloud_stream *out)
{
    status st = OK;
    cloud_stream s = {.fd = -1};
    TRY(TAKE(s.path, strlen(path) + 1));
    memcpy(s.path, path, strlen(path));
    TRY(TAKE(s.buffer, STREAM_ROOM + 1));
    // O_NONBLOCK: a pipe without a writer would be waited for
    s.fd = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
    TRY(check_file(&s));
    *out = s;
    s = (cloud_stream){.fd = -1};

done:
    stream_close(&s);
    return st;
}

void stream_close(cloud_stream *s)
{
    if (s->path && s->fd >= 0) {
        (void)close(s->fd);
    }
    free(s->path);
    free(s->buffer);
    *s = (cloud_stream){.fd = -1};
}

uint64_t stream_place(const cloud_stream *s)
{
    return s->loaded - (s->end - s->begin);
}

uint64_t stream_left(const cloud_stream *s)
{
    const uint64_t place = stream_place(s);
    return s->size > place ? s->size - place : 0;
}

void stream_in_bytes(cloud_stream *s)
{
    s->line = 0;
}

// what is left moves to the front, and the rest of the buffer is filled
static status fill(cloud_stream *s)
{
    memmove(s->buffer, s->buffer + s->begin, s->end - s->begin);
    s->end -= s->begin;
    s->begin = 0;
    while (s->end < STREAM_ROOM) {
        const ssize_t n = read(s->fd, s->buffer + s->end, STREAM_ROOM - s->end);
        if (n < 0 && errno == EINTR) {
            continue;
        }
        if (n < 0) {
            return stream_fail(s, "%s", strerror(errno));
        }
        if (n == 0) {
            break;
        }
        s->end += (size_t)n;
        s->loaded += (uint64_t)n;
    }
    s->buffer[s->end] = 0;
    if (s->progress) {
        s->progress(s->context, s->loaded < s->size ? (double)s->loaded / (double)s->size : 1);
    }
    return OK;
}

status stream_peek(cloud_stream *s, size_t most, const unsigned char **bytes, size_t *count)
{
    status st = OK;
    if (s->end - s->begin < most) {
        TRY(fill(s));
    }
    *bytes = s->buffer + s->begin;
    *count = s->end - s->begin < most ? s->end - s->begin : most;

done:
    return st;
}

// the end of the line that begins at s->begin; NULL where it is not in the buffer
static unsigned char *line_end(const cloud_stream *s)
{
    return memchr(s->buffer + s->begin, '\n', s->end - s->begin);
}

status stream_line(cloud_stream *s, char **line)
{
    status st = OK;
    unsigned char *end = line_end(s);
    *line = NULL;
    if (!end) {
        TRY(fill(s));
        end = line_end(s);
    }
    if (s->begin == s->end) {
        return OK;
    }
    s->line++;
    unsigned char *start = s->buffer + s->begin;
    const size_t length = end ? (size_t)(end - start) : s->end - s->begin;
    if (memchr(start, 0, length)) {
        TRY(stream_fail(s, "there is a zero byte: it is no text"));
    }
    if (!end && s->end == STREAM_ROOM) {
        TRY(stream_fail(s, "the line has more than %d bytes", STREAM_ROOM));
    }
    s->begin += length + (end ? 1 : 0);
    start[length] = 0;
    if (length > 0 && start[length - 1] == '\r') {
        start[length - 1] = 0;
    }
    *line = (char *)start;

done:
    return st;
}

status stream_row(cloud_stream *s, uint64_t row, uint64_t count, char **line)
{
    status st = OK;
    do {
        TRY(stream_line(s, line));
    } while (*line && (*line)[strspn(*line, " \t")] == '\0');
    if (!*line) {
        TRY(stream_fail(s, "the file ends after %llu of %llu points", (unsigned long long)row,
                        (unsigned long long)count));
    }

done:
    return st;
}

status stream_bytes(cloud_stream *s, size_t count, const unsigned char **bytes)
{
    status st = OK;
    size_t found = 0;
    TRY(stream_peek(s, count, bytes, &found));
    if (found < count) {
        TRY(stream_fail(s, "the file ends in the middle of its points"));
    }
    s->begin += count;

done:
    return st;
}

status stream_skip(cloud_stream *s, uint64_t count)
{
    status st = OK;
    const uint64_t here = s->end - s->begin;
    if (count <= here) {
        s->begin += (size_t)count;
        return OK;
    }
    if (count > stream_left(s)) {
        TRY(stream_fail(s, "the file ends before its points"));
    }
    if (lseek(s->fd, (off_t)(count - here), SEEK_CUR) < 0) {
        TRY(stream_fail(s, "%s", strerror(errno)));
    }
    s->loaded += count - here;
    s->begin = s->end = 0;

done:
    return st;
}
