// base/input_file.c
#include "base/input_file.h"

#include "base/memory.h"

#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

void input_file_free(input_file *f)
{
    free(f->path);
    free(f->bytes);
    *f = (input_file){0};
}

// bytes of the UTF-8 character at `c`, 0 where there is none
static int character(const unsigned char *c)
{
    const int n = c[0] < 0x80 ? 1 : c[0] >= 0xf0 && c[0] < 0xf5 ? 4 : c[0] >= 0xe0 ? 3 : 2;
    if (n > 1 && (c[0] < 0xc2 || c[0] >= 0xf5)) {
        return 0;
    }
    for (int i = 1; i < n; i++) {
        if ((c[i] & 0xc0) != 0x80) {
            return 0;
        }
    }
    return n;
}

// without what would break a line, a terminal or a text in UTF-8
static void flatten(char *words)
{
    for (int n = 1; *words; words += n > 0 ? n : 1) {
        const unsigned char byte = (unsigned char)*words;
        n = character((const unsigned char *)words);
        if (n == 0 || byte < 32 || byte == 127) {
            *words = '?';
        }
    }
}

// the end of a path, where it is long
static void tell_path(const char *path, char words[200])
{
    const size_t count = strlen(path), room = 199;
    (void)snprintf(words, room + 1, "%s", path + (count > room ? count - room : 0));
    flatten(words);
}

status input_file_fail(const input_file *f, long line, const char *format, ...)
{
    char path[200], words[512];
    va_list args;
    va_start(args, format);
    (void)vsnprintf(words, sizeof words, format, args);
    va_end(args);
    tell_path(f->path ? f->path : "file", path);
    flatten(words); // it may quote the file
    return line > 0 ? status_fail(ERR_FILE, "%s:%ld: %s", path, line, words)
                    : status_fail(ERR_FILE, "%s: %s", path, words);
}

static status open_fail(const input_file *f, const key_text *name, const char *why)
{
    char path[200];
    tell_path(f->path, path);
    return status_fail_at(ERR_FILE, name->at.line, name->at.column, "%s: %s", path, why);
}

static status join_path(const char *directory, const char *name, char **out)
{
    status st = OK;
    const bool alone = name[0] == '/' || !directory || directory[0] == '\0';
    const size_t length = alone ? 0 : strlen(directory);
    const char *slash = alone || directory[length - 1] == '/' ? "" : "/";
    const size_t size = strlen(name) + length + 2;
    TRY(TAKE(*out, size));
    (void)snprintf(*out, size, "%s%s%s", alone ? "" : directory, slash, name);

done:
    return st;
}

static status read_bytes(int fd, const key_text *name, input_file *f, size_t size, bool grows)
{
    status st = OK;
    TRY(TAKE(f->bytes, size + 1));
    // one more than it should have shows a file that grows
    while (f->count <= size) {
        const ssize_t n = read(fd, f->bytes + f->count, size + 1 - f->count);
        if (n < 0 && errno == EINTR) {
            continue;
        }
        if (n < 0) {
            TRY(open_fail(f, name, strerror(errno)));
        }
        if (n == 0) {
            break;
        }
        f->count += (size_t)n;
    }
    if (f->count != size && !grows) {
        TRY(open_fail(f, name, "it changes while it is read"));
    }
    f->count = f->count < size ? f->count : size;
    f->bytes[f->count] = 0;

done:
    return st;
}

static status read_file(const char *directory, const key_text *name, size_t most, bool grows,
                        input_file *out)
{
    status st = OK;
    int fd = -1;
    struct stat about;
    input_file f = {0};

    if (!name->text || name->text[0] == '\0') {
        TRY(status_fail_at(ERR_INPUT, name->at.line, name->at.column, "a file's name is empty"));
    }
    TRY(join_path(directory, name->text, &f.path));
    // O_NONBLOCK: a pipe without a writer would be waited for
    fd = open(f.path, O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
    if (fd < 0 || fstat(fd, &about) != 0) {
        TRY(open_fail(&f, name, strerror(errno)));
    }
    if (!S_ISREG(about.st_mode)) {
        TRY(open_fail(&f, name,
                      S_ISDIR(about.st_mode) ? "it is a directory" : "it is no regular file"));
    }
    if ((uint64_t)about.st_size > most) {
        char words[80];
        (void)snprintf(words, sizeof words, "it has %lld bytes; at most %zu are read",
                       (long long)about.st_size, most);
        TRY(open_fail(&f, name, words));
    }
    TRY(read_bytes(fd, name, &f, (size_t)about.st_size, grows));
    *out = f;
    f = (input_file){0};

done:
    if (fd >= 0) {
        (void)close(fd);
    }
    input_file_free(&f);
    return st;
}

status input_file_read(const char *directory, const key_text *name, size_t most, input_file *out)
{
    return read_file(directory, name, most, false, out);
}

status input_file_read_so_far(const char *directory, const key_text *name, size_t most,
                              input_file *out)
{
    return read_file(directory, name, most, true, out);
}

bool input_file_begins(const input_file *f, const char *words)
{
    const size_t n = strlen(words);
    return f->count >= n && memcmp(f->bytes, words, n) == 0;
}

bool input_file_ends(const input_file *f, const char *words)
{
    size_t n = strlen(words), end = f->count;
    while (end > 0 && strchr(" \t\r\n", f->bytes[end - 1]) && f->bytes[end - 1] != 0) {
        end--;
    }
    return end >= n && memcmp(f->bytes + end - n, words, n) == 0;
}
