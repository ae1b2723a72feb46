// measure/cloud_ply.c
// PLY: a header of elements with properties, then their values as text or bytes. Only the element
// with x, y and z is read; those in front of it are passed over, those behind it never reached.
#include "measure/cloud_parts.h"

#include "base/memory.h"

#include <stdio.h>
#include <string.h>

enum { MOST_ELEMENTS = 64, MOST_PROPERTIES = 256, MOST_LINES = 2000, WORD = 64 };

typedef struct property {
    scalar_kind kind;
    scalar_kind length; // of a list's length; SCALAR_NONE: no list
} property;

typedef struct element {
    char name[WORD];
    uint64_t count;
    int first, nproperty; // in ply.property
    int axis[3];          // which of its properties is x, y, z; -1
    bool lists;
} element;

typedef struct ply {
    enum { PLY_UNKNOWN, PLY_TEXT, PLY_LITTLE, PLY_BIG } form;
    int nelement, nproperty;
    element element[MOST_ELEMENTS];
    property property[MOST_PROPERTIES];
} ply;

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
    char word[WORD];
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
    char count[WORD];
    if (p->nelement == MOST_ELEMENTS) {
        return stream_fail(s, "more than %d elements", MOST_ELEMENTS);
    }
    element *e = &p->element[p->nelement];
    *e = (element){.first = p->nproperty, .axis = {-1, -1, -1}};
    if (!cloud_word(&rest, e->name, sizeof e->name) || !cloud_word(&rest, count, sizeof count) ||
        !cloud_count(count, &e->count)) {
        return stream_fail(s, "an element needs a name and how many there are of it");
    }
    p->nelement++;
    return OK;
}

static status read_property(const cloud_stream *s, const char *rest, ply *p)
{
    char word[WORD], name[WORD];
    if (p->nelement == 0 || p->nproperty == MOST_PROPERTIES) {
        return stream_fail(s, p->nelement == 0 ? "a property before any element"
                                               : "too many properties");
    }
    element *e = &p->element[p->nelement - 1];
    property q = {.length = SCALAR_NONE};
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
    p->property[p->nproperty++] = q;
    e->nproperty++;
    return OK;
}

static status read_header(cloud_stream *s, ply *p)
{
    status st = OK;
    char *line = NULL, word[WORD];
    for (int i = 0; i < MOST_LINES; i++) {
        TRY(stream_line(s, &line));
        if (!line) {
            break;
        }
        const char *rest = line;
        (void)cloud_word(&rest, word, sizeof word);
        if (strcmp(word, "end_header") == 0) {
            return p->form != PLY_UNKNOWN ? OK : stream_fail(s, "a header without a format");
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

// bytes of one element without lists; what lists take at least
static uint64_t stride_of(const ply *p, const element *e)
{
    uint64_t bytes = 0;
    for (int i = e->first; i < e->first + e->nproperty; i++) {
        const property *q = &p->property[i];
        bytes += scalar_size(q->length == SCALAR_NONE ? q->kind : q->length);
    }
    return bytes;
}

// One element with lists, by the byte; xyz NULL: passed over.
static status walk_lists(cloud_stream *s, const ply *p, const element *e, double *xyz)
{
    status st = OK;
    const bool big = p->form == PLY_BIG;
    const unsigned char *bytes = NULL;
    for (int i = 0; i < e->nproperty; i++) {
        const property *q = &p->property[e->first + i];
        if (q->length != SCALAR_NONE) {
            TRY(stream_bytes(s, scalar_size(q->length), &bytes));
            const double length = scalar_read(bytes, q->length, big);
            if (!(length >= 0 && length <= (double)stream_left(s))) {
                TRY(stream_fail(s, "a list of %g values", length));
            }
            TRY(stream_skip(s, (uint64_t)length * scalar_size(q->kind)));
            continue;
        }
        TRY(stream_bytes(s, scalar_size(q->kind), &bytes));
        for (int d = 0; xyz && d < 3; d++) {
            if (e->axis[d] == i) {
                xyz[d] = scalar_read(bytes, q->kind, big);
            }
        }
    }

done:
    return st;
}

static status pass_over(cloud_stream *s, const ply *p, const element *e)
{
    status st = OK;
    const uint64_t stride = stride_of(p, e);
    char *line = NULL;
    // so that counts that no file bears out end here
    if (e->count > 0 && (e->nproperty == 0 || e->count > stream_left(s))) {
        TRY(stream_fail(s, "%llu elements '%s' are more than the file holds",
                        (unsigned long long)e->count, e->name));
    }
    if (p->form != PLY_TEXT && !e->lists) {
        if (e->count > stream_left(s) / stride) {
            TRY(stream_fail(s, "%llu elements '%s' are more than the file holds",
                            (unsigned long long)e->count, e->name));
        }
        return stream_skip(s, e->count * stride);
    }
    for (uint64_t i = 0; i < e->count; i++) {
        TRY(p->form == PLY_TEXT ? stream_line(s, &line) : walk_lists(s, p, e, NULL));
        if (p->form == PLY_TEXT && !line) {
            TRY(stream_fail(s, "the file ends before its points"));
        }
    }

done:
    return st;
}

// a line may hold lists in front of x, y and z
static status columns_of_line(const cloud_stream *s, const ply *p, const element *e,
                              const char *line, int column[3])
{
    char word[WORD];
    uint64_t length = 0, at = 0;
    for (int i = 0; i < e->nproperty; i++) {
        for (int d = 0; d < 3; d++) {
            column[d] = e->axis[d] == i ? (int)at : column[d];
        }
        const bool list = p->property[e->first + i].length != SCALAR_NONE;
        if (!cloud_word(&line, word, sizeof word)) {
            return stream_fail(s, "%d properties, but the header has %d", i, e->nproperty);
        }
        at++;
        if (list && (!cloud_count(word, &length) || length > STREAM_ROOM)) {
            return stream_fail(s, "'%s' is no list's length", word);
        }
        for (uint64_t k = 0; list && k < length; k++, at++) {
            if (!cloud_word(&line, word, sizeof word)) {
                return stream_fail(s, "a list of %llu values ends early",
                                   (unsigned long long)length);
            }
        }
    }
    return OK;
}

static status read_text(cloud_stream *s, const ply *p, const element *e, cloud_builder *b)
{
    status st = OK;
    char *line = NULL;
    int column[3] = {e->axis[0], e->axis[1], e->axis[2]};
    for (uint64_t i = 0; i < e->count; i++) {
        double xyz[3];
        TRY(stream_row(s, i, e->count, &line));
        TRY(e->lists ? columns_of_line(s, p, e, line, column) : OK);
        TRY(cloud_row(s, line, column, xyz));
        builder_put(b, xyz);
    }

done:
    return st;
}

static status read_bytes(cloud_stream *s, const ply *p, const element *e, cloud_builder *b)
{
    status st = OK;
    const size_t stride = (size_t)stride_of(p, e);
    size_t offset[3] = {0};
    scalar_kind kind[3];
    const unsigned char *bytes = NULL;
    double xyz[3] = {0};
    for (int d = 0; d < 3; d++) {
        const element before = {.first = e->first, .nproperty = e->axis[d]};
        offset[d] = (size_t)stride_of(p, &before);
        kind[d] = p->property[e->first + e->axis[d]].kind;
    }
    for (uint64_t i = 0; i < e->count; i++) {
        if (e->lists) {
            TRY(walk_lists(s, p, e, xyz));
        } else {
            TRY(stream_bytes(s, stride, &bytes));
            for (int d = 0; d < 3; d++) {
                xyz[d] = scalar_read(bytes + offset[d], kind[d], p->form == PLY_BIG);
            }
        }
        builder_put(b, xyz);
    }

done:
    return st;
}

static status find_points(const cloud_stream *s, const ply *p, int *which)
{
    for (int i = 0; i < p->nelement; i++) {
        const int *axis = p->element[i].axis;
        if (axis[0] >= 0 && axis[1] >= 0 && axis[2] >= 0) {
            *which = i;
            return OK;
        }
    }
    return stream_fail(s, "no element has the properties x, y and z");
}

status cloud_ply(cloud_stream *s, cloud_builder *b, cloud_report *report)
{
    static const char *const names[] = {"", "PLY, text", "PLY, binary little endian",
                                        "PLY, binary big endian"};
    status st = OK;
    ply *p = NULL;
    int which = 0;
    TRY(TAKE(p, 1));
    TRY(read_header(s, p));
    TRY(find_points(s, p, &which));
    (void)snprintf(report->kind, sizeof report->kind, "%s", names[p->form]);
    const element *e = &p->element[which];
    // a text takes a digit and a blank or line's end each
    const uint64_t least = p->form == PLY_TEXT ? 2 * (uint64_t)e->nproperty : stride_of(p, e);
    TRY(builder_expect(b, s, e->count, least));
    if (p->form != PLY_TEXT) {
        stream_in_bytes(s);
    }
    for (int i = 0; i < which; i++) {
        TRY(pass_over(s, p, &p->element[i]));
    }
    TRY(p->form == PLY_TEXT ? read_text(s, p, e, b) : read_bytes(s, p, e, b));

done:
    free(p);
    return st;
}
