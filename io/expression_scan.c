// io/expression_scan.c
#include "io/expression_scan.h"

#include "base/nearest.h"
#include "io/config.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

static const char *const functions[] = {
    "sin",  "cos",   "tan",   "asin",  "acos", "atan", "atan2", "sinh", "cosh",
    "tanh", "asinh", "acosh", "atanh", "exp",  "ln",   "log",   "log2", "log10",
    "sqrt", "abs",   "rint",  "sign",  "min",  "max",  "sum",   "avg",
};
// those of them that take more than one number
static const char *const functions_of_several[] = {"atan2", "min", "max", "sum", "avg"};
static const char *const constants[] = {"pi", "L", "s"};
static const char *const places[] = {"x", "y"};

enum {
    NFUNCTION = sizeof functions / sizeof *functions,
    NSEVERAL = sizeof functions_of_several / sizeof *functions_of_several,
    NCONSTANT = sizeof constants / sizeof *constants,
    NPLACE = sizeof places / sizeof *places,
};

typedef struct scan {
    const char *text;
    const expression_scope *scope;
    expression_error *error;
    int at;
    int depth;
    char open[CONFIG_MAX_EXPRESSION + 1]; // 'f': the parentheses of a function, '1': of one
                                          // that takes one number, '(': others
    bool after_function;                  // a parenthesis must follow
    bool takes_several;                   // the function does
    bool after_number;
} scan;

status expression_refuse(expression_error *error, int position, const char *format, ...)
{
    va_list args;
    va_start(args, format);
    error->position = position;
    (void)vsnprintf(error->words, sizeof error->words, format, args);
    va_end(args);
    return ERR_INPUT;
}

static bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

static bool is_letter(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

static int name_length(const char *p)
{
    int n = 0;
    while (is_letter(p[n]) || is_digit(p[n])) {
        n++;
    }
    return n;
}

static bool is_one_of(const char *name, int n, const char *const *list)
{
    for (int i = 0; i < n; i++) {
        if (strcmp(name, list[i]) == 0) {
            return true;
        }
    }
    return false;
}

static status unknown_name(scan *s, const char *name)
{
    char words[NEAREST_WORDS];
    nearest near = nearest_to(name);
    const bool function = s->text[s->at + name_length(s->text + s->at)] == '(';
    for (int i = 0; i < NCONSTANT && !function; i++) {
        nearest_offer(&near, constants[i], constants[i]);
    }
    for (int i = 0; i < NFUNCTION && function; i++) {
        nearest_offer(&near, functions[i], functions[i]);
    }
    for (int i = 0; i < NPLACE && s->scope->has_place && !function; i++) {
        nearest_offer(&near, places[i], places[i]);
    }
    if (near.best[0]) {
        return expression_refuse(s->error, s->at, "unknown name '%s' in arithmetic%s", name,
                                 nearest_words(&near, words));
    }
    return expression_refuse(
        s->error, s->at,
        "unknown name '%s' in arithmetic; known are pi, L, s%s and functions such as "
        "sin, sqrt, min",
        name, s->scope->has_place ? ", x, y" : "");
}

static status scan_name(scan *s)
{
    char name[40];
    const int n = name_length(s->text + s->at);
    (void)snprintf(name, sizeof name, "%.*s", n, s->text + s->at);
    if (s->after_number) {
        char suffix[sizeof name + 1];
        double factor = 1;
        (void)snprintf(suffix, sizeof suffix, "_%s", name);
        return expression_refuse(s->error, s->at, "an operator is missing before '%s'%s", name,
                                 key_written_unit(suffix, &factor)[0]
                                     ? ": units stand in the key's name, numbers alone here"
                                     : "");
    }
    if (strcmp(name, "L") == 0 && !s->scope->has_L) {
        return expression_refuse(s->error, s->at, "L is not known here: %s", s->scope->no_L);
    }
    if (strcmp(name, "s") == 0 && !s->scope->has_s) {
        return expression_refuse(s->error, s->at, "s may not stand here: %s", s->scope->no_s);
    }
    s->after_function = is_one_of(name, NFUNCTION, functions);
    s->takes_several = is_one_of(name, NSEVERAL, functions_of_several);
    const bool place = s->scope->has_place && is_one_of(name, NPLACE, places);
    if (!s->after_function && !place && !is_one_of(name, NCONSTANT, constants)) {
        return unknown_name(s, name);
    }
    s->at += n;
    return OK;
}

static void scan_number(scan *s)
{
    const char *p = s->text;
    while (is_digit(p[s->at]) || p[s->at] == '.') {
        s->at++;
    }
    const char e = p[s->at];
    if (e == 'e' || e == 'E') {
        const char sign = p[s->at + 1];
        const int ahead = sign == '+' || sign == '-' ? 2 : 1;
        if (is_digit(p[s->at + ahead])) {
            s->at += ahead;
            while (is_digit(p[s->at])) {
                s->at++;
            }
        }
    }
    s->after_number = true;
}

static status scan_bracket(scan *s, char c, bool function)
{
    if (c == '(') {
        s->open[s->depth++] = !function ? '(' : s->takes_several ? 'f' : '1';
    } else if (s->depth == 0) {
        return expression_refuse(s->error, s->at, "')' without '('");
    } else if (c == ')') {
        s->depth--;
    } else if (s->open[s->depth - 1] == '1') {
        return expression_refuse(s->error, s->at, "',' in a function that takes one number");
    } else if (s->open[s->depth - 1] != 'f') {
        return expression_refuse(s->error, s->at, "',' outside of a function's parentheses");
    }
    s->at++;
    return OK;
}

// two-character operators as a whole, so that a single '=' (assignment), '&', '|' or '!' stands out
static status scan_operator(scan *s)
{
    static const char *const doubles[] = {"==", "!=", "<=", ">=", "&&", "||"};
    const char *p = s->text + s->at;
    for (size_t i = 0; i < sizeof doubles / sizeof *doubles; i++) {
        if (strncmp(p, doubles[i], 2) == 0) {
            s->at += 2;
            return OK;
        }
    }
    if (strchr("+-*/^<>?:", *p)) {
        s->at++;
        return OK;
    }
    if (*p == '=') {
        return expression_refuse(s->error, s->at, "'=' in arithmetic: nothing is assigned here");
    }
    if (*p > ' ' && *p < 0x7F) {
        return expression_refuse(s->error, s->at, "'%c' cannot stand in arithmetic", *p);
    }
    return expression_refuse(s->error, s->at, "this character cannot stand in arithmetic");
}

static status scan_piece(scan *s)
{
    const char c = s->text[s->at];
    if (c == ' ') {
        s->at++;
        return OK;
    }
    const bool function = s->after_function;
    if (function && c != '(') {
        return expression_refuse(s->error, s->at, "a function wants parentheses");
    }
    if (is_letter(c)) {
        return scan_name(s);
    }
    s->after_function = false;
    s->after_number = false;
    if (is_digit(c) || (c == '.' && is_digit(s->text[s->at + 1]))) {
        scan_number(s);
        return OK;
    }
    if (c == '(' || c == ')' || (c == ',' && s->depth > 0)) {
        return scan_bracket(s, c, function);
    }
    if (c == ',') {
        return expression_refuse(s->error, s->at,
                                 "',' in arithmetic: one number is wanted, with a "
                                 "point for the decimals");
    }
    return scan_operator(s);
}

status expression_scan(const char *text, const expression_scope *scope, expression_error *error)
{
    scan s = {.text = text, .scope = scope, .error = error};
    if (strlen(text) > CONFIG_MAX_EXPRESSION) {
        return expression_refuse(error, 0, "arithmetic longer than %d characters",
                                 CONFIG_MAX_EXPRESSION);
    }
    while (text[s.at]) {
        const status st = scan_piece(&s);
        if (st != OK) {
            return st;
        }
    }
    if (s.depth > 0 || s.after_function) {
        const bool open = s.depth > 0, function = open && s.open[s.depth - 1] != '(';
        // a list or map in brackets ends the text there
        return expression_refuse(error, s.at,
                                 function ? "')' is missing; a ',' in brackets needs quotes around "
                                            "the whole"
                                 : open   ? "')' is missing"
                                          : "a function wants parentheses");
    }
    return OK;
}

bool expression_knows(const char *name)
{
    return is_one_of(name, NCONSTANT, constants) || is_one_of(name, NFUNCTION, functions) ||
           is_one_of(name, NPLACE, places);
}

bool expression_uses(const char *text, char name)
{
    for (const char *p = text; *p;) {
        const int n = name_length(p);
        if (n == 1 && *p == name) {
            return true;
        }
        p += n ? n : 1;
    }
    return false;
}
