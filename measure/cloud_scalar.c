// measure/cloud_scalar.c
// Numbers in point clouds, as bytes and as text.
#include "measure/cloud_parts.h"

#include "io/number.h"

#include <ctype.h>
#include <math.h>
#include <string.h>
#include <strings.h>

size_t scalar_size(scalar_kind k)
{
    static const size_t size[] = {1, 1, 2, 2, 4, 4, 8, 8, 4, 8, 0};
    return size[k];
}

static uint64_t bits_of(const unsigned char *bytes, size_t size, bool big_endian)
{
    uint64_t bits = 0;
    for (size_t i = 0; i < size; i++) {
        bits |= (uint64_t)bytes[i] << 8 * (big_endian ? size - 1 - i : i);
    }
    return bits;
}

double scalar_read(const unsigned char *bytes, scalar_kind k, bool big_endian)
{
    const uint64_t bits = bits_of(bytes, scalar_size(k), big_endian);
    const uint32_t half = (uint32_t)bits;
    float single = 0;
    double value = 0;
    switch (k) {
    case SCALAR_I8:
        return (int8_t)bits;
    case SCALAR_I16:
        return (int16_t)bits;
    case SCALAR_I32:
        return (int32_t)bits;
    case SCALAR_I64:
        return (double)(int64_t)bits;
    case SCALAR_F32:
        memcpy(&single, &half, sizeof single);
        return (double)single;
    case SCALAR_F64:
        memcpy(&value, &bits, sizeof value);
        return value;
    default:
        return (double)bits;
    }
}

typedef struct decimal {
    uint64_t digits; // without the point
    int ndigit;      // of them, without zeros in front
    int power;       // of ten
    bool any, cut;   // any digit; more of them than `digits` holds
} decimal;

enum { MOST_DIGITS = 19 }; // of a 64-bit number

static const char *read_digits(const char *c, bool fraction, decimal *d)
{
    for (; *c >= '0' && *c <= '9'; c++) {
        d->any = true;
        if (d->ndigit < MOST_DIGITS) {
            d->digits = 10 * d->digits + (uint64_t)(*c - '0');
            d->ndigit += d->digits > 0;
            d->power -= fraction;
        } else {
            d->cut = true;
            d->power += !fraction;
        }
    }
    return c;
}

// "e-05" where it is one
static const char *read_power(const char *c, decimal *d)
{
    const char *digit = c + 1 + (c[0] != 0 && (c[1] == '+' || c[1] == '-'));
    if ((*c != 'e' && *c != 'E') || !isdigit((unsigned char)*digit)) {
        return c;
    }
    int power = 0;
    const bool negative = c[1] == '-';
    for (; isdigit((unsigned char)*digit); digit++) {
        power = power < 10000 ? 10 * power + (*digit - '0') : power;
    }
    d->power += negative ? -power : power;
    return digit;
}

// nan, inf, infinity with an optional nan(...) left out: what printf writes
static bool read_word(const char **text, double *value)
{
    static const struct {
        const char *word;
        double value;
    } known[] = {{"nan", NAN}, {"infinity", INFINITY}, {"inf", INFINITY}};
    for (int i = 0; i < 3; i++) {
        const size_t n = strlen(known[i].word);
        if (strncasecmp(*text, known[i].word, n) == 0) {
            *text += n;
            *value = known[i].value;
            return true;
        }
    }
    return false;
}

// what the short way cannot hold, by the long one
static double read_slowly(const char *from, const char *end, bool comma)
{
    char word[400];
    const size_t n = (size_t)(end - from) < sizeof word - 1 ? (size_t)(end - from) : 399;
    double value = NAN;
    memcpy(word, from, n);
    word[n] = 0;
    for (char *c = word; comma && *c; c++) {
        *c = *c == ',' ? '.' : *c;
    }
    return number_read(word, &value) ? value : NAN;
}

bool cloud_number(const char **text, bool comma, double *value)
{
    // 10^27 = 2^27 5^27 is exact in 64 bits, and so is every smaller one
    static const long double ten[] = {1e0L,  1e1L,  1e2L,  1e3L,  1e4L,  1e5L,  1e6L,
                                      1e7L,  1e8L,  1e9L,  1e10L, 1e11L, 1e12L, 1e13L,
                                      1e14L, 1e15L, 1e16L, 1e17L, 1e18L, 1e19L, 1e20L,
                                      1e21L, 1e22L, 1e23L, 1e24L, 1e25L, 1e26L, 1e27L};
    const char *c = *text + (**text == '-' || **text == '+');
    const bool negative = **text == '-';
    decimal d = {0};
    const char *end = read_digits(c, false, &d);
    if (*end == '.' || (comma && *end == ',')) {
        end = read_digits(end + 1, true, &d);
    }
    if (!d.any) {
        const bool is_word = read_word(&c, value);
        *text = is_word ? c : *text;
        return is_word;
    }
    end = read_power(end, &d);
    const int size = d.power < 0 ? -d.power : d.power;
    if (d.cut || size > 27) {
        *value = read_slowly(c, end, comma);
    } else {
        const long double whole = (long double)d.digits;
        *value = (double)(d.power < 0 ? whole / ten[size] : whole * ten[size]);
    }
    *value = negative ? -*value : *value;
    *text = end;
    return true;
}

bool cloud_word(const char **text, char *word, size_t room)
{
    const char *c = *text + strspn(*text, " \t");
    const size_t length = strcspn(c, " \t"), n = length < room ? length : room - 1;
    memcpy(word, c, n);
    word[n] = 0;
    *text = c + length;
    return length > 0;
}

bool cloud_count(const char *word, uint64_t *count)
{
    uint64_t value = 0;
    const char *c = word;
    for (; isdigit((unsigned char)*c); c++) {
        if (value > (UINT64_MAX >> 1) / 10 - 1) {
            return false;
        }
        value = 10 * value + (uint64_t)(*c - '0');
    }
    *count = value;
    return c > word && *c == 0;
}

status cloud_row(const cloud_stream *s, const char *line, const int column[3], double xyz[3])
{
    const char *c = line;
    for (int i = 0, found = 0; found < 3; i++) {
        c += strspn(c, " \t");
        if (*c == 0) {
            return stream_fail(s, "%d columns, too few for x, y and z", i);
        }
        const size_t length = strcspn(c, " \t");
        for (int d = 0; d < 3; d++) {
            const char *at = c;
            if (column[d] == i && (!cloud_number(&at, false, &xyz[d]) || at != c + length)) {
                return stream_fail(s, "'%.*s' is no number", length < 40 ? (int)length : 40, c);
            }
            found += column[d] == i;
        }
        c += length;
    }
    return OK;
}
