// io/case_text.c
#include "io/case_text.h"

#include "base/memory.h"
#include "io/utf8.h"

#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static const mark whole_file = {WHOLE_FILE_LINE, 0};

static status too_large(const config *cfg)
{
    return config_fail(cfg, whole_file, "the file is larger than %d MB: not a case",
                       CONFIG_MAX_BYTES >> 20);
}

static status check_kind(const config *cfg, int file)
{
    struct stat about;
    if (fstat(file, &about) != 0) {
        return config_fail(cfg, whole_file, "cannot read: %s", strerror(errno));
    }
    if (S_ISDIR(about.st_mode)) {
        return config_fail(cfg, whole_file, "this is a directory, not a case file");
    }
    if (S_ISREG(about.st_mode) && about.st_size > CONFIG_MAX_BYTES) {
        return too_large(cfg);
    }
    return OK;
}

// all bytes, but at most one more than allowed: /dev/zero has no end
static status read_all(config *cfg, int file)
{
    status st = OK;
    size_t room = 64 << 10;
    TRY(TAKE(cfg->text, room));
    for (;;) {
        const ssize_t got = read(file, cfg->text + cfg->length, room - 1 - cfg->length);
        if (got < 0 && errno == EINTR) {
            continue;
        }
        if (got < 0) {
            TRY(config_fail(cfg, whole_file, "cannot read: %s", strerror(errno)));
        }
        if (got == 0) {
            break;
        }
        cfg->length += (size_t)got;
        if (cfg->length > CONFIG_MAX_BYTES) {
            TRY(too_large(cfg));
        }
        if (cfg->length == room - 1) {
            room *= 2;
            char *wider = realloc(cfg->text, room);
            if (!wider) {
                TRY(status_fail(ERR_RESOURCE, "out of memory: %zu bytes", room));
            }
            cfg->text = wider;
        }
    }
    cfg->text[cfg->length] = '\0';

done:
    return st;
}

status case_text_load(config *cfg)
{
    status st = OK;
    const bool from_stdin = strcmp(cfg->path, "-") == 0;
    const int file = from_stdin ? STDIN_FILENO : open(cfg->path, O_RDONLY | O_CLOEXEC | O_NOCTTY);
    if (file < 0) {
        return config_fail(cfg, whole_file, "cannot open: %s", strerror(errno));
    }
    TRY(check_kind(cfg, file));
    TRY(read_all(cfg, file));

done:
    if (!from_stdin) {
        (void)close(file);
    }
    return st;
}

// triangles of a binary STL surface that has exactly this many bytes; -1: it is none
static long long stl_triangles(const unsigned char *bytes, size_t length)
{
    enum { HEADER = 80, TRIANGLE = 50 };
    if (length < HEADER + 4) {
        return -1;
    }
    const unsigned char *b = bytes + HEADER;
    const long long n = b[0] | b[1] << 8 | b[2] << 16 | (long long)b[3] << 24;
    return (long long)length == HEADER + 4 + TRIANGLE * n ? n : -1;
}

status case_text_kind(const config *cfg)
{
    static const struct {
        const char *magic, *words;
    } others[] = {
        {"\x89PNG", "this is a PNG image, not a case; name it in a case under section.png"},
        {"\x89HDF", "this is an HDF5 file, not a case; `stiffaxis report` takes results"},
    };
    for (size_t i = 0; i < sizeof others / sizeof *others; i++) {
        const size_t n = strlen(others[i].magic);
        if (cfg->length > n && memcmp(cfg->text, others[i].magic, n) == 0) {
            return config_fail(cfg, whole_file, "%s", others[i].words);
        }
    }
    return stl_triangles((const unsigned char *)cfg->text, cfg->length) > 0
               ? config_fail(cfg, whole_file,
                             "this is an STL surface, not a case; name it in a case under "
                             "reach.tissue")
               : OK;
}

// one character that libyaml would refuse with fewer words, or take where we do not
static status check_character(const config *cfg, uint32_t point, bool indentation, int override,
                              mark where)
{
    const mark at = case_mark(override, where);
    if (point == 0) {
        return config_fail(cfg, at, "a NUL byte: not a text file");
    }
    if (point == '\t' && indentation) {
        return config_fail(cfg, at, "a tab in the indentation; use spaces");
    }
    if (point == '%' && where.column == 1) {
        return config_fail(cfg, at, "a case has no YAML directives ('%%' at the start of a line)");
    }
    const bool space = point == '\t' || point == '\n' || point == '\r' || point == 0x85;
    if ((point < 0x20 && !space) || (point >= 0x7F && point < 0xA0 && !space) || point == 0xFEFF ||
        point == 0xFFFE || point == 0xFFFF) {
        return config_fail(cfg, at, "the control character U+%04X", (unsigned)point);
    }
    return OK;
}

// steps one character on; a line ends with LF, CR LF or CR
static void step(uint32_t point, const char *next, mark *at)
{
    if (point == '\n' || (point == '\r' && *next != '\n')) {
        *at = (mark){at->line + 1, 1};
    } else {
        at->column++;
    }
}

size_t case_text_bom(const char *text, size_t length)
{
    return length >= 3 && memcmp(text, "\xEF\xBB\xBF", 3) == 0 ? 3 : 0;
}

status case_text_check(const config *cfg, const char *text, size_t length, int override)
{
    mark at = {1, 1};
    bool indentation = true;
    for (size_t i = case_text_bom(text, length); i < length;) {
        uint32_t point = 0;
        const int n = utf8_read(text + i, length - i, &point);
        if (n == 0) {
            return config_fail(cfg, case_mark(override, at), "the byte 0x%02X is not UTF-8 text",
                               (unsigned char)text[i]);
        }
        indentation = at.column == 1 || (indentation && text[i - 1] == ' ');
        const status st = check_character(cfg, point, indentation, override, at);
        if (st != OK) {
            return st;
        }
        i += (size_t)n;
        step(point, text + i, &at);
    }
    return OK;
}

unsigned case_text_at(const char *text, size_t length, int line, int column)
{
    mark at = {1, 1};
    for (size_t i = case_text_bom(text, length); i < length;) {
        uint32_t point = 0;
        const int n = utf8_read(text + i, length - i, &point);
        if (n == 0 || at.line > line) {
            return 0;
        }
        if (at.line == line && at.column == column) {
            return point;
        }
        i += (size_t)n;
        step(point, text + i, &at);
    }
    return 0;
}
