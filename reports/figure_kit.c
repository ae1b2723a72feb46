// reports/figure_kit.c
#include "reports/figure_kit.h"

#include "reports/markup.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#define LOOK(points, weight, red, green, blue)                                                     \
    {                                                                                              \
        .size = (points), .style = (weight), .ink = {(red), (green), (blue), 1 }                   \
    }
const text_look LOOK_TITLE = LOOK(18, TEXT_BOLD, 0.13, 0.15, 0.19);
const text_look LOOK_HEADING = LOOK(14.2, TEXT_BOLD, 0.13, 0.15, 0.19);
const text_look LOOK_TEXT = LOOK(14.2, TEXT_PLAIN, 0.13, 0.15, 0.19);
const text_look LOOK_SMALL = LOOK(SMALLEST_LETTERS, TEXT_PLAIN, 0.36, 0.40, 0.46);
const text_look LOOK_TICK = LOOK(SMALLEST_LETTERS, TEXT_PLAIN, 0.36, 0.40, 0.46);

text_look look_aligned(text_look look, text_align align)
{
    look.align = align;
    return look;
}

text_look look_inked(text_look look, colour ink)
{
    look.ink = ink;
    return look;
}

text_look look_haloed(text_look look)
{
    look.halo = 2.5;
    return look;
}

// --- numbers ---

static void put(number_text *out, const char *word)
{
    const size_t used = strlen(out->text);
    (void)snprintf(out->text + used, sizeof out->text - used, "%s", word);
}

// printf's digits with a true minus sign, and its exponent as a power of ten
static number_text typeset(const char *plain)
{
    static const char *const raised[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    number_text out = {{0}};
    const char *e = strchr(plain, 'e');
    for (const char *p = plain; *p && p != e; p++) {
        put(&out, *p == '-' ? "−" : (char[]){*p, 0});
    }
    if (e) {
        put(&out, e[1] == '-' ? "×10⁻" : "×10");
        for (const char *p = e + 2 + (e[2] == '0'); *p; p++) {
            put(&out, raised[(*p - '0') % 10]);
        }
    }
    return out;
}

// very large and very small numbers take a power of ten
static bool wants_power(double value)
{
    return fabs(value) < 1e-4 || fabs(value) >= 1e7;
}

number_text number_digits(double value, int digits)
{
    char plain[40];
    if (value == 0) {
        return (number_text){"0"};
    }
    if (!isfinite(value)) {
        return (number_text){"not finite"};
    }
    if (wants_power(value)) {
        (void)snprintf(plain, sizeof plain, "%.*e", digits - 1, value);
    } else {
        const int decimals = digits - 1 - (int)floor(log10(fabs(value)));
        (void)snprintf(plain, sizeof plain, "%.*f", decimals > 0 ? decimals : 0, value);
    }
    return typeset(plain);
}

number_text number_short(double value, int digits)
{
    char plain[40];
    if (value == 0 || !isfinite(value) || wants_power(value)) {
        return number_digits(value, digits);
    }
    const int decimals = digits - 1 - (int)floor(log10(fabs(value)));
    (void)snprintf(plain, sizeof plain, "%.*f", decimals > 0 ? decimals : 0, value);
    if (strchr(plain, '.')) {
        size_t end = strlen(plain);
        while (plain[end - 1] == '0') {
            end--;
        }
        plain[end - (plain[end - 1] == '.')] = 0;
    }
    return typeset(plain);
}

number_text number_fixed(double value, int decimals)
{
    char plain[40];
    if (!isfinite(value) || fabs(value) >= 1e9) {
        return number_digits(value, 4);
    }
    // no minus in front of what rounds to zero
    const double half = 0.5 * pow(10, -decimals);
    (void)snprintf(plain, sizeof plain, "%.*f", decimals, fabs(value) < half ? 0 : value);
    return typeset(plain);
}

// --- letters ---

void say(canvas *c, double x, double y, text_look look, const char *format, ...)
{
    char text[512];
    va_list arguments;
    va_start(arguments, format);
    (void)vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    canvas_text(c, x, y, &look, text);
}

void say_within(canvas *c, double x, double y, double width, text_look look, const char *text)
{
    char cut[512];
    for (size_t columns = utf8_clean(text, cut, sizeof cut); columns > 1; columns--) {
        utf8_shorten(text, columns, cut, sizeof cut);
        if (canvas_text_width(c, &look, cut) <= width) {
            break;
        }
    }
    canvas_text(c, x, y, &look, cut);
}

// how many bytes of text, up to the end of a word, fit on a line; at least one word
static size_t line_length(canvas *c, const char *text, double width, const text_look *look)
{
    char line[512];
    size_t fits = strcspn(text, " ");
    for (size_t end = fits; text[end];) {
        end += 1 + strcspn(text + end + 1, " ");
        if (end >= sizeof line) {
            break;
        }
        memcpy(line, text, end);
        line[end] = 0;
        if (canvas_text_width(c, look, line) > width) {
            break;
        }
        fits = end;
    }
    return fits < sizeof line ? fits : sizeof line - 1;
}

double say_paragraph(canvas *c, double x, double y, double width, text_look look, const char *text)
{
    while (*text) {
        char line[512];
        const size_t length = line_length(c, text, width, &look);
        memcpy(line, text, length);
        line[length] = 0;
        say_within(c, x, y, width, look, line);
        y += 1.4 * look.size;
        text += length;
        text += strspn(text, " ");
    }
    return y;
}
