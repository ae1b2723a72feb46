// io/utf8.c
#include "io/utf8.h"

#include <string.h>

int utf8_read(const char *text, size_t length, uint32_t *point)
{
    const unsigned char *c = (const unsigned char *)text;
    if (length == 0) {
        return 0;
    }
    if (c[0] < 0x80) {
        *point = c[0];
        return 1;
    }
    const int n = c[0] >= 0xF0 ? 4 : c[0] >= 0xE0 ? 3 : 2;
    if (c[0] < 0xC2 || c[0] > 0xF4 || (size_t)n > length) {
        return 0;
    }
    uint32_t value = c[0] & (0x7Fu >> n);
    for (int i = 1; i < n; i++) {
        if ((c[i] & 0xC0) != 0x80) {
            return 0;
        }
        value = value << 6 | (c[i] & 0x3Fu);
    }
    static const uint32_t least[5] = {0, 0, 0x80, 0x800, 0x10000};
    if (value < least[n] || value > 0x10FFFF || (value >= 0xD800 && value <= 0xDFFF)) {
        return 0;
    }
    *point = value;
    return n;
}

size_t utf8_count(const char *text)
{
    size_t n = 0;
    for (; *text; text++) {
        n += ((unsigned char)*text & 0xC0) != 0x80;
    }
    return n;
}

int utf8_is_plain(uint32_t point)
{
    const int control = point < 0x20 || (point >= 0x7F && point < 0xA0);
    const int separator = point == 0x2028 || point == 0x2029 || point == 0xFEFF;
    const int direction = point == 0x200E || point == 0x200F ||
                          (point >= 0x202A && point <= 0x202E) ||
                          (point >= 0x2066 && point <= 0x2069);
    return !control && !separator && !direction;
}

void utf8_make_plain(char *text)
{
    char *to = text;
    for (size_t left = strlen(text); left > 0;) {
        uint32_t point = 0;
        const int n = utf8_read(text, left, &point);
        if (n > 0 && utf8_is_plain(point)) {
            memmove(to, text, (size_t)n);
            to += n;
        } else {
            *to++ = '?';
        }
        text += n ? n : 1;
        left -= (size_t)(n ? n : 1);
    }
    *to = '\0';
}
