// meshes/msh_cursor.c
#include "meshes/msh_cursor.h"

#include <limits.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// no program writes a number longer than this
enum { LONGEST_NUMBER = 120 };

// more of anything than this is no section
enum { MOST_THINGS = 20000000 };

msh_cursor msh_cursor_at_start(const input_file *file)
{
    return (msh_cursor){
        .file = file, .at = file->bytes, .end = file->bytes + file->count, .line = 1};
}

status msh_fail(const msh_cursor *c, const char *format, ...)
{
    char words[400];
    va_list args;
    va_start(args, format);
    (void)vsnprintf(words, sizeof words, format, args);
    va_end(args);
    if (c->binary) {
        return input_file_fail(c->file, 0, "at byte %zu: %s", (size_t)(c->at - c->file->bytes),
                               words);
    }
    return input_file_fail(c->file, c->line, "%s", words);
}

static bool is_blank(unsigned char c)
{
    return c == ' ' || (c >= '\t' && c <= '\r');
}

static void skip_blanks(msh_cursor *c)
{
    while (c->at < c->end && is_blank(*c->at)) {
        c->line += *c->at++ == '\n';
    }
}

bool msh_at_end(msh_cursor *c)
{
    skip_blanks(c);
    return c->at == c->end;
}

void msh_skip_line(msh_cursor *c)
{
    const unsigned char *stop = memchr(c->at, '\n', (size_t)(c->end - c->at));
    c->at = stop ? stop + 1 : c->end;
    c->line += stop != NULL;
}

static size_t word_length(const msh_cursor *c)
{
    const unsigned char *at = c->at;
    while (at < c->end && !is_blank(*at)) {
        at++;
    }
    return (size_t)(at - c->at);
}

status msh_word(msh_cursor *c, char word[MSH_NAME])
{
    skip_blanks(c);
    const size_t n = word_length(c);
    if (n == 0) {
        return msh_fail(c, "the file ends here: it is not complete");
    }
    if (n >= MSH_NAME) {
        return msh_fail(c, "a word of %zu letters begins with '%.20s'", n, (const char *)c->at);
    }
    memcpy(word, c->at, n);
    word[n] = '\0';
    c->at += n;
    return OK;
}

status msh_quoted(msh_cursor *c, char name[MSH_NAME])
{
    skip_blanks(c);
    const size_t left = (size_t)(c->end - c->at);
    const size_t line = left > 0 ? strcspn((const char *)c->at, "\n") : 0;
    const unsigned char *stop = line > 1 ? memchr(c->at + 1, '"', line - 1) : NULL;
    if (left == 0 || *c->at != '"' || !stop) {
        return msh_fail(c, "a name in quotation marks is missing");
    }
    const size_t n = (size_t)(stop - c->at) - 1;
    if (n >= MSH_NAME || memchr(c->at, 0, n)) {
        return msh_fail(c, "a name of %zu letters is too long", n);
    }
    memcpy(name, c->at + 1, n);
    name[n] = '\0';
    c->at = stop + 1;
    return OK;
}

// --- numbers as text

static status number_fail(const msh_cursor *c, const char *what)
{
    const size_t n = word_length(c);
    if (n == 0) {
        return msh_fail(c, "%s is missing: the file ends here", what);
    }
    return msh_fail(c, "%s is no number: '%.*s'", what, (int)(n < 40 ? n : 40),
                    (const char *)c->at);
}

static status text_integer(msh_cursor *c, const char *what, int64_t *value)
{
    skip_blanks(c);
    const unsigned char *at = c->at;
    const bool negative = at < c->end && *at == '-';
    at += negative || (at < c->end && *at == '+');
    const unsigned char *first = at;
    int64_t v = 0;
    for (; at < c->end && *at >= '0' && *at <= '9' && at - first < 18; at++) {
        v = 10 * v + (*at - '0');
    }
    if (at == first || (at < c->end && !is_blank(*at))) {
        return number_fail(c, what);
    }
    *value = negative ? -v : v;
    c->at = at;
    return OK;
}

// [+-] digits [. digits] [e [+-] digits], with the digits' value where they fit
typedef struct decimal {
    bool good, negative;
    size_t length;
    int digits; // that count
    uint64_t mantissa;
    int exponent;
} decimal;

static const unsigned char *scan_digits(const unsigned char *at, const unsigned char *end,
                                        decimal *d)
{
    for (; at < end && *at >= '0' && *at <= '9'; at++) {
        d->good = true;
        d->digits += d->digits > 0 || *at != '0';
        d->mantissa = d->digits < 20 ? 10 * d->mantissa + (uint64_t)(*at - '0') : d->mantissa;
    }
    return at;
}

static decimal scan_decimal(const unsigned char *from, const unsigned char *end)
{
    decimal d = {0};
    const unsigned char *at = from;
    if (at < end && (*at == '-' || *at == '+')) {
        d.negative = *at++ == '-';
    }
    at = scan_digits(at, end, &d);
    if (at < end && *at == '.') {
        const unsigned char *point = ++at;
        at = scan_digits(at, end, &d);
        d.exponent = (int)(point - at);
    }
    if (d.good && at < end && (*at == 'e' || *at == 'E')) {
        decimal power = {0};
        const bool negative = ++at < end && *at == '-';
        at += at < end && (*at == '-' || *at == '+');
        at = scan_digits(at, end, &power);
        d.good = power.good;
        const int size = power.digits < 6 ? (int)power.mantissa : 99999;
        d.exponent += negative ? -size : size;
    }
    d.length = (size_t)(at - from);
    d.good = d.good && d.length <= LONGEST_NUMBER && (at == end || is_blank(*at));
    return d;
}

static const double ten[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                             1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

static status text_real(msh_cursor *c, const char *what, double *value)
{
    skip_blanks(c);
    const decimal d = scan_decimal(c->at, c->end);
    if (!d.good) {
        return number_fail(c, what);
    }
    // both factors are exact, so the one rounding is the right one
    if (d.digits < 20 && d.mantissa <= (uint64_t)1 << 53 && abs(d.exponent) <= 22) {
        const double v = (double)d.mantissa;
        const double size = d.exponent < 0 ? v / ten[-d.exponent] : v * ten[d.exponent];
        *value = d.negative ? -size : size;
    } else {
        *value = strtod((const char *)c->at, NULL);
    }
    if (!isfinite(*value)) {
        return msh_fail(c, "%s is too large", what);
    }
    c->at += d.length;
    return OK;
}

// --- numbers as bytes

static status take_bytes(msh_cursor *c, const char *what, size_t n, void *out)
{
    if ((size_t)(c->end - c->at) < n) {
        return msh_fail(c, "%s is missing: the file ends here", what);
    }
    unsigned char *to = out;
    for (size_t i = 0; i < n; i++) {
        to[i] = c->at[c->swapped ? n - 1 - i : i];
    }
    c->at += n;
    return OK;
}

status msh_int(msh_cursor *c, const char *what, int64_t *value)
{
    status st = OK;
    int32_t v = 0;
    if (!c->binary) {
        return text_integer(c, what, value);
    }
    TRY(take_bytes(c, what, sizeof v, &v));
    *value = v;

done:
    return st;
}

status msh_size(msh_cursor *c, const char *what, int64_t *value)
{
    return c->binary ? take_bytes(c, what, sizeof *value, value) : text_integer(c, what, value);
}

status msh_real(msh_cursor *c, const char *what, double *value)
{
    status st = OK;
    if (!c->binary) {
        return text_real(c, what, value);
    }
    TRY(take_bytes(c, what, sizeof *value, value));
    if (!isfinite(*value)) {
        return msh_fail(c, "%s is %s", what, isnan(*value) ? "no number" : "infinite");
    }

done:
    return st;
}

status msh_count(msh_cursor *c, const char *what, bool wide, size_t text_bytes, size_t binary_bytes,
                 int *count)
{
    status st = OK;
    int64_t n = 0;
    TRY(wide ? msh_size(c, what, &n) : msh_int(c, what, &n));
    const size_t left = (size_t)(c->end - c->at);
    const size_t each = c->binary ? binary_bytes : text_bytes;
    if (n < 0 || n > MOST_THINGS || (uint64_t)n * each > left) {
        return msh_fail(c, "%s %lld is not possible: the file has no room for so many", what,
                        (long long)n);
    }
    *count = (int)n;

done:
    return st;
}
