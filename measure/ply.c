// measure/ply.c
#include "measure/ply.h"

#include <string.h>

enum { MOST_LINES = 2000 };

static scalar_kind kind_of(const char *word)
{
    static const struct {
        const char *name;
        scalar_kind kind;
    } known[] = {{"char", SCALAR_I8},     {"int8", SCALAR_I8},    {"uchar", SCALAR_U8},
                 {"uint8", SCALAR_U8},    {"short", SCALAR_I16},  {"int16", SCALAR_I16},
                 {"ushort", SCALAR_U16},  {"uint16", SCALAR_U16}, {"int", SCALAR_I32},
                 {"int32", SCALAR_I32},   {"uint", SCALAR_U32},   {"uint32", SCALAR_U32},
                 {"int64", SCALAR_I64},   {"uint64", SCALAR_U64}, {"float", SCALAR_F32},
                 {"float32", SCALAR_F32}, {"double", SCALAR_F64}, {"float64", SCALAR_F64}};
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        if (strcmp(word, known[i].name) == 0) {
            return known[i].kind;
        }
    }
    return SCALAR_NONE;
}

static status read_form(const cloud_stream *s, const char *rest, ply *p)
{
    char word[PLY_WORD];
    static const char *const forms[] = {"", "ascii", "binary_little_endian", "binary_big_endian"};
    (void)cloud_word(&rest, word, sizeof word);
    for (int i = PLY_TEXT; i <= PLY_BIG; i++) {
        if (strcmp(word, forms[i]) == 0) {
            p->form = i;
            return OK;
        }
    }
    return stream_fail(s, "format '%s': ascii, binary_little_endian and binary_big_endian are read",
                       word);
}

static status read_element(const cloud_stream *s, const char *rest, ply *p)
{
    char count[PLY_WORD];
    if (p->nelement == PLY_ELEMENTS) {
        return stream_fail(s, "more than %d elements", PLY_ELEMENTS);
    }
    ply_element *e = &p->element[p->nelement];
    *e = (ply_element){.first = p->nproperty, .axis = {-1, -1, -1}, .corners = -1};
    if (!cloud_word(&rest, e->name, sizeof e->name) || !cloud_word(&rest, count, sizeof count) ||
        !cloud_count(count, &e->count)) {
        return stream_fail(s, "an element needs a name and how many there are of it");
    }
    p->nelement++;
    return OK;
}

static status read_property(const cloud_stream *s, const char *rest, ply *p)
{
    char word[PLY_WORD], name[PLY_WORD];
    if (p->nelement == 0 || p->nproperty == PLY_PROPERTIES) {
        return stream_fail(s, p->nelement == 0 ? "a property before any element"
                                               : "too many properties");
    }
    ply_element *e = &p->element[p->nelement - 1];
    ply_property q = {.length = SCALAR_NONE};
    bool whole = cloud_word(&rest, word, sizeof word);
    if (whole && strcmp(word, "list") == 0) {
        whole = cloud_word(&rest, word, sizeof word);
        q.length = kind_of(word);
        whole = whole && q.length <= SCALAR_U64 && cloud_word(&rest, word, sizeof word);
        e->lists = true;
    }
    q.kind = kind_of(word);
    if (!whole || q.kind == SCALAR_NONE || !cloud_word(&rest, name, sizeof name)) {
        return stream_fail(s, "this is no property: a type that is known, then a name");
    }
    for (int d = 0; d < 3; d++) {
        const char axis[2] = {(char)('x' + d), 0};
        if (q.length == SCALAR_NONE && strcmp(name, axis) == 0) {
            e->axis[d] = e->nproperty;
        }
    }
    if (q.length != SCALAR_NONE &&
        (strcmp(name, "vertex_indices") == 0 || strcmp(name, "vertex_index") == 0)) {
        e->corners = e->nproperty;
    }
    p->property[p->nproperty++] = q;
    e->nproperty++;
    return OK;
}

status ply_read_header(cloud_stream *s, ply *p)
{
    status st = OK;
    char *line = NULL, word[PLY_WORD];
    for (int i = 0; i < MOST_LINES; i++) {
        TRY(stream_line(s, &line));
        if (!line) {
            break;
        }
        const char *rest = line;
        (void)cloud_word(&rest, word, sizeof word);
        if (strcmp(word, "end_header") == 0) {
            TRY(p->form != PLY_UNKNOWN ? OK : stream_fail(s, "a header without a format"));
            if (p->form != PLY_TEXT) {
                stream_in_bytes(s);
            }
            return OK;
        } else if (strcmp(word, "format") == 0) {
            TRY(read_form(s, rest, p));
        } else if (strcmp(word, "element") == 0) {
            TRY(read_element(s, rest, p));
        } else if (strcmp(word, "property") == 0) {
            TRY(read_property(s, rest, p));
        } else if (i > 0 && word[0] && strcmp(word, "comment") != 0 &&
                   strcmp(word, "obj_info") != 0) {
            TRY(stream_fail(s, "'%s' is no word of a PLY header", word));
        }
    }
    TRY(stream_fail(s, "the header does not end"));

done:
    return st;
}

uint64_t ply_stride(const ply *p, const ply_element *e)
{
    uint64_t bytes = 0;
    for (int i = e->first; i < e->first + e->nproperty; i++) {
        const ply_property *q = &p->property[i];
        bytes += scalar_size(q->length == SCALAR_NONE ? q->kind : q->length);
    }
    return bytes;
}

static status row_of_text(cloud_stream *s, const ply *p, const ply_element *e, ply_take *take,
                          void *context)
{
    status st = OK;
    char *line = NULL;
    do {
        TRY(stream_line(s, &line));
    } while (line && line[strspn(line, " \t")] == 0);
    if (!line) {
        TRY(stream_fail(s, "the file ends before its last '%s'", e->name));
    }
    const char *c = line;
    for (int i = 0; i < e->nproperty; i++) {
        const bool list = p->property[e->first + i].length != SCALAR_NONE;
        double value = 1;
        c += strspn(c, " \t");
        if (list && (!cloud_number(&c, false, &value) || !(value >= 0 && value < STREAM_ROOM))) {
            TRY(stream_fail(s, "there is no list's length where one is due"));
        }
        const uint64_t count = (uint64_t)value;
        for (uint64_t k = 0; k < count; k++) {
            c += strspn(c, " \t");
            if (!cloud_number(&c, false, &value) || (*c && *c != ' ' && *c != '\t')) {
                TRY(stream_fail(s, "there is no number where one is due"));
            }
            TRY(take(context, i, k, count, value));
        }
    }

done:
    return st;
}

static status row_of_bytes(cloud_stream *s, const ply *p, const ply_element *e, ply_take *take,
                           void *context)
{
    status st = OK;
    const bool big = p->form == PLY_BIG;
    const unsigned char *bytes = NULL;
    for (int i = 0; i < e->nproperty; i++) {
        const ply_property *q = &p->property[e->first + i];
        double length = 1;
        if (q->length != SCALAR_NONE) {
            TRY(stream_bytes(s, scalar_size(q->length), &bytes));
            length = scalar_read(bytes, q->length, big);
        }
        if (!(length >= 0 && length <= (double)stream_left(s))) {
            TRY(stream_fail(s, "a list of %g values", length));
        }
        for (uint64_t k = 0; k < (uint64_t)length; k++) {
            TRY(stream_bytes(s, scalar_size(q->kind), &bytes));
            TRY(take(context, i, k, (uint64_t)length, scalar_read(bytes, q->kind, big)));
        }
    }

done:
    return st;
}

status ply_row(cloud_stream *s, const ply *p, const ply_element *e, ply_take *take, void *context)
{
    return p->form == PLY_TEXT ? row_of_text(s, p, e, take, context)
                               : row_of_bytes(s, p, e, take, context);
}
