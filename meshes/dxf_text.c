// meshes/dxf_text.c
#include "meshes/dxf_text.h"

#include "base/memory.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

// no honest entity has more numbers
enum { MOST_PAIRS = 400000, LONGEST_NUMBER = 63 };

// a coordinate beyond this is damage, and its square would leave the range of the checks
static const double LARGEST_NUMBER = 1e15;

// the next line without blanks around it; false at the end of the file
static bool next_line(dxf_text *t, const char **from, size_t *length)
{
    const char *text = (const char *)t->file->bytes;
    const size_t count = t->file->count;
    if (t->at >= count) {
        return false;
    }
    size_t first = t->at, end = t->at;
    while (end < count && text[end] != '\n') {
        end++;
    }
    t->at = end + 1;
    while (first < end && isspace((unsigned char)text[first])) {
        first++;
    }
    while (end > first && isspace((unsigned char)text[end - 1])) {
        end--;
    }
    *from = text + first;
    *length = end - first;
    return true;
}

// digits only, with a sign: strtol would take more
static bool read_code(const char *text, size_t length, int *code)
{
    size_t i = 0;
    const bool negative = length > 0 && text[0] == '-';
    i += negative;
    if (i == length || length > 5) {
        return false;
    }
    for (*code = 0; i < length; i++) {
        if (!isdigit((unsigned char)text[i])) {
            return false;
        }
        *code = 10 * *code + (text[i] - '0');
    }
    *code = negative ? -*code : *code;
    return true;
}

status dxf_next(dxf_text *t)
{
    const char *code = NULL;
    size_t length = 0;
    const long before = t->line;
    t->line += before == 0 ? 1 : 2;
    if (!next_line(t, &code, &length)) {
        return input_file_fail(t->file, t->line, "the file ends before its EOF");
    }
    if (!read_code(code, length, &t->code)) {
        return input_file_fail(t->file, t->line, "a group code is expected here%s",
                               before == 0 ? ": this is no ASCII DXF file" : "");
    }
    if (!next_line(t, &t->value, &t->length)) {
        return input_file_fail(t->file, t->line, "the file ends before its EOF");
    }
    return OK;
}

bool dxf_is(const dxf_text *t, int code, const char *word)
{
    return t->code == code && t->length == strlen(word) && memcmp(t->value, word, t->length) == 0;
}

status dxf_number(const dxf_text *t, double *out)
{
    char text[LONGEST_NUMBER + 1] = "", *end = text;
    if (t->length <= LONGEST_NUMBER) {
        memcpy(text, t->value, t->length);
    }
    // strtod would also take words and hexadecimal numbers
    const bool plain = strspn(text, "0123456789+-.eE") == t->length;
    *out = strtod(text, &end);
    if (!plain || end == text || *end || !(fabs(*out) <= LARGEST_NUMBER)) {
        return input_file_fail(t->file, t->line + 1, "the value of group code %d is no number",
                               t->code);
    }
    return OK;
}

void dxf_word(const dxf_text *t, char out[DXF_NAME])
{
    const size_t n = t->length < DXF_NAME - 1 ? t->length : DXF_NAME - 1;
    memcpy(out, t->value, n);
    out[n] = '\0';
    // what a message prints
    for (size_t i = 0; i < n; i++) {
        out[i] = iscntrl((unsigned char)out[i]) ? '?' : out[i];
    }
}

static bool is_number(int code)
{
    return (code >= 10 && code < 80) || (code >= 90 && code < 100) || (code >= 210 && code < 240);
}

static status add_pair(const dxf_text *t, dxf_entity *e, double value)
{
    if (e->npair >= MOST_PAIRS) {
        return input_file_fail(t->file, e->line, "%s has more than %d numbers", e->kind,
                               MOST_PAIRS);
    }
    if (e->npair >= e->room) {
        const int room = 2 * e->room + 64;
        dxf_pair *more = realloc(e->pair, (size_t)room * sizeof *more);
        if (!more) {
            return status_fail(ERR_RESOURCE, "out of memory");
        }
        e->pair = more;
        e->room = room;
    }
    e->pair[e->npair++] = (dxf_pair){t->code, value};
    return OK;
}

status dxf_entity_read(dxf_text *t, dxf_entity *e)
{
    status st = OK;
    e->npair = 0;
    e->line = t->line;
    e->layer[0] = '\0';
    dxf_word(t, e->kind);
    TRY(dxf_next(t));
    for (bool plain = true; t->code != 0;) {
        double value = 0;
        if (t->code == 8) {
            dxf_word(t, e->layer);
        } else if (t->code == 102) {
            // reactors and dictionaries of other programs stand between { and }
            plain = t->length > 0 && t->value[0] != '{';
        } else if (plain && is_number(t->code)) {
            TRY(dxf_number(t, &value));
            TRY(add_pair(t, e, value));
        }
        TRY(dxf_next(t));
    }

done:
    return st;
}

void dxf_entity_free(dxf_entity *e)
{
    free(e->pair);
    *e = (dxf_entity){0};
}

double dxf_get(const dxf_entity *e, int code, double otherwise)
{
    for (int i = 0; i < e->npair; i++) {
        if (e->pair[i].code == code) {
            return e->pair[i].value;
        }
    }
    return otherwise;
}

int dxf_get_int(const dxf_entity *e, int code, int otherwise)
{
    const double value = dxf_get(e, code, otherwise);
    return fabs(value) < 1e9 ? (int)value : -1;
}

int dxf_count(const dxf_entity *e, int code)
{
    int n = 0;
    for (int i = 0; i < e->npair; i++) {
        n += e->pair[i].code == code;
    }
    return n;
}

status dxf_need(const dxf_text *t, const dxf_entity *e, const int *codes)
{
    for (; *codes; codes++) {
        if (dxf_count(e, *codes) == 0) {
            return input_file_fail(t->file, e->line, "%s without group code %d", e->kind, *codes);
        }
    }
    return OK;
}
