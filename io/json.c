// io/json.c
#include "io/json.h"

#include "base/memory.h"
#include "io/number.h"
#include "io/utf8.h"

#include <errno.h>
#include <math.h>
#include <string.h>

enum { MAX_DEPTH = 64 };

struct json {
    FILE *stream;
    status st; // the first failure; nothing is written after it
    int error; // errno of a failed write
    int depth;
    bool ended; // the one document is complete
    char kind[MAX_DEPTH];
    bool any[MAX_DEPTH]; // something stands in this object or array already
};

status json_open(FILE *stream, json **out)
{
    json *j = NULL;
    *out = NULL;
    const status st = memory_take((void **)&j, 1, sizeof *j);
    if (st == OK) {
        j->stream = stream;
        *out = j;
    }
    return st;
}

static void put(json *j, const char *text)
{
    if (j->st == OK && fputs(text, j->stream) == EOF) {
        j->error = errno;
        j->st = ERR_RESOURCE;
    }
}

static void put_text(json *j, const char *text)
{
    size_t left = strlen(text);
    put(j, "\"");
    while (left > 0 && j->st == OK) {
        uint32_t point = 0xFFFD; // stands for bytes that are not UTF-8, from file names for example
        char piece[8] = "\xEF\xBF\xBD";
        const int n = utf8_read(text, left, &point);
        const int used = n ? n : 1;
        if (point == '"' || point == '\\') {
            (void)snprintf(piece, sizeof piece, "\\%c", (char)point);
        } else if (point < 0x20 || point == 0x7F || point == 0x2028 || point == 0x2029) {
            (void)snprintf(piece, sizeof piece, "\\u%04x", (unsigned)point);
        } else if (n) {
            memcpy(piece, text, (size_t)n);
            piece[n] = '\0';
        }
        put(j, piece);
        text += used;
        left -= (size_t)used;
    }
    put(j, "\"");
}

static void new_line(json *j)
{
    put(j, "\n");
    for (int i = 0; i < j->depth; i++) {
        put(j, "  ");
    }
}

static void misuse(json *j, const char *what, const char *key)
{
    if (j->st == OK) {
        j->st = status_fail(ERR_BUG, "json: %s, at key '%s'", what, key ? key : "none");
    }
}

// what stands before any value: comma, line and key; false where no value may stand here
static bool begin(json *j, const char *key)
{
    if (j->depth == 0) {
        if (j->ended) {
            misuse(j, "a second document", key);
        } else if (key) {
            misuse(j, "a key outside of any object", key);
        }
        return j->st == OK;
    }
    const int top = j->depth - 1;
    if ((j->kind[top] == '{') != (key != NULL)) {
        misuse(j, key ? "a key inside an array" : "no key inside an object", key);
    }
    put(j, j->any[top] ? "," : "");
    j->any[top] = true;
    new_line(j);
    if (key) {
        put_text(j, key);
        put(j, ": ");
    }
    return j->st == OK;
}

static void end_value(json *j)
{
    j->ended = j->depth == 0;
}

static void open_level(json *j, const char *key, char kind)
{
    if (!begin(j, key)) {
        return;
    }
    if (j->depth == MAX_DEPTH) {
        misuse(j, "nested too deeply", key);
        return;
    }
    put(j, kind == '{' ? "{" : "[");
    j->kind[j->depth] = kind;
    j->any[j->depth] = false;
    j->depth++;
}

static void close_level(json *j, char kind)
{
    if (j->st != OK) {
        return;
    }
    if (j->depth == 0 || j->kind[j->depth - 1] != kind) {
        misuse(j,
               kind == '{' ? "an object's end without its begin"
                           : "an array's end without its begin",
               NULL);
        return;
    }
    j->depth--;
    if (j->any[j->depth]) {
        new_line(j);
    }
    put(j, kind == '{' ? "}" : "]");
    end_value(j);
}

void json_object(json *j, const char *key)
{
    open_level(j, key, '{');
}

void json_object_end(json *j)
{
    close_level(j, '{');
}

void json_array(json *j, const char *key)
{
    open_level(j, key, '[');
}

void json_array_end(json *j)
{
    close_level(j, '[');
}

static void put_real(json *j, double value)
{
    char text[NUMBER_TEXT];
    number_text(value, text);
    put(j, isfinite(value) ? text : "null");
}

static void word(json *j, const char *key, const char *text)
{
    if (begin(j, key)) {
        put(j, text);
        end_value(j);
    }
}

void json_real(json *j, const char *key, double value)
{
    if (begin(j, key)) {
        put_real(j, value);
        end_value(j);
    }
}

void json_integer(json *j, const char *key, long value)
{
    char text[NUMBER_TEXT];
    (void)snprintf(text, sizeof text, "%ld", value);
    word(j, key, text);
}

void json_flag(json *j, const char *key, bool value)
{
    word(j, key, value ? "true" : "false");
}

void json_null(json *j, const char *key)
{
    word(j, key, "null");
}

void json_text(json *j, const char *key, const char *value)
{
    if (!value) {
        json_null(j, key);
    } else if (begin(j, key)) {
        put_text(j, value);
        end_value(j);
    }
}

void json_reals(json *j, const char *key, int n, const double *values)
{
    if (!begin(j, key)) {
        return;
    }
    put(j, "[");
    for (int i = 0; i < n; i++) {
        put(j, i ? ", " : "");
        put_real(j, values[i]);
    }
    put(j, "]");
    end_value(j);
}

void json_mat6(json *j, const char *key, mat6 m)
{
    json_array(j, key);
    for (int i = 0; i < 6; i++) {
        json_reals(j, NULL, 6, m.a[i]);
    }
    json_array_end(j);
}

status json_close(json *j)
{
    if (j->st == OK && (j->depth > 0 || !j->ended)) {
        misuse(j, j->depth > 0 ? "closed inside an object or array" : "closed without a document",
               NULL);
    }
    put(j, "\n");
    if (j->st == OK && (fflush(j->stream) == EOF || ferror(j->stream))) {
        j->error = errno;
        j->st = ERR_RESOURCE;
    }
    const status st = j->st;
    if (st == ERR_RESOURCE) {
        (void)status_fail(st, "writing JSON failed: %s",
                          j->error ? strerror(j->error) : "no reason given");
    }
    free(j);
    return st;
}
