// io/number.c
#include "io/number.h"

#include <locale.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// the locale's decimal separator where it is one character other than a point, else 0
static char foreign_point(void)
{
    const char *point = localeconv()->decimal_point;
    return point[0] != '.' && point[1] == '\0' ? point[0] : '\0';
}

void number_text(double value, char text[NUMBER_TEXT])
{
    if (!isfinite(value)) {
        (void)snprintf(text, NUMBER_TEXT, "%s", isnan(value) ? "nan" : value > 0 ? "inf" : "-inf");
        return;
    }
    for (int digits = 15; digits <= 17; digits++) {
        (void)snprintf(text, NUMBER_TEXT, "%.*g", digits, value);
        if (strtod(text, NULL) == value) {
            break;
        }
    }
    const char comma = foreign_point();
    char *at = comma ? strchr(text, comma) : NULL;
    if (at) {
        *at = '.';
    }
}

static const char *skip_digits(const char *p)
{
    while (*p >= '0' && *p <= '9') {
        p++;
    }
    return p;
}

static bool is_decimal(const char *p)
{
    p += *p == '+' || *p == '-';
    const char *whole = p;
    p = skip_digits(p);
    long ndigit = p - whole;
    if (*p == '.') {
        const char *part = ++p;
        p = skip_digits(p);
        ndigit += p - part;
    }
    if (ndigit == 0) {
        return false;
    }
    if (*p == 'e' || *p == 'E') {
        p++;
        p += *p == '+' || *p == '-';
        const char *exponent = p;
        p = skip_digits(p);
        if (p == exponent) {
            return false;
        }
    }
    return *p == '\0';
}

bool number_read(const char *text, double *value)
{
    if (!is_decimal(text)) {
        return false;
    }
    const char comma = foreign_point();
    const char *point = comma ? strchr(text, '.') : NULL;
    char copy[512];
    if (!point) {
        *value = strtod(text, NULL);
        return true;
    }
    const int n = snprintf(copy, sizeof copy, "%s", text);
    if (n >= (int)sizeof copy) {
        return false;
    }
    copy[point - text] = comma;
    *value = strtod(copy, NULL);
    return true;
}

const char *plural(int count)
{
    return count == 1 ? "" : "s";
}
