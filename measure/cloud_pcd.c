// measure/cloud_pcd.c
// PCD of the Point Cloud Library: a header of fields, then points as text, as bytes, or as LZF
// packed columns.
#include "measure/cloud_parts.h"

#include "base/memory.h"

#include <stdio.h>
#include <string.h>

enum { MOST_FIELDS = 128, MOST_COUNT = 65536, MOST_LINES = 100, WORD = 64 };

typedef enum pcd_form { PCD_TEXT, PCD_BYTES, PCD_PACKED, PCD_UNKNOWN } pcd_form;

typedef struct pcd {
    int nfield;
    char name[MOST_FIELDS][WORD];
    uint64_t size[MOST_FIELDS], count[MOST_FIELDS];
    char type[MOST_FIELDS];
    uint64_t width, height, points; // 0: not said
    int said;                       // how many of SIZE, TYPE and COUNT
    pcd_form form;
    int axis[3]; // which fields
} pcd;

// one list of the header: as many words as there are fields
typedef status take_word(const cloud_stream *s, const char *word, int i, pcd *p);

static status take_name(const cloud_stream *s, const char *word, int i, pcd *p)
{
    (void)s;
    (void)snprintf(p->name[i], WORD, "%s", word);
    p->count[i] = 1;
    p->size[i] = 4;
    p->type[i] = 'F';
    return OK;
}

static status take_size(const cloud_stream *s, const char *word, int i, pcd *p)
{
    const bool good = cloud_count(word, &p->size[i]) && p->size[i] >= 1 && p->size[i] <= 8 &&
                      (p->size[i] & (p->size[i] - 1)) == 0;
    return good ? OK : stream_fail(s, "SIZE %s: 1, 2, 4 or 8", word);
}

static status take_type(const cloud_stream *s, const char *word, int i, pcd *p)
{
    p->type[i] = word[0];
    const bool good = word[1] == 0 && strchr("FIU", word[0]);
    return good ? OK : stream_fail(s, "TYPE %s: F, I or U", word);
}

static status take_count(const cloud_stream *s, const char *word, int i, pcd *p)
{
    const bool good = cloud_count(word, &p->count[i]) && p->count[i] <= MOST_COUNT;
    return good ? OK : stream_fail(s, "COUNT %s: up to %d", word, MOST_COUNT);
}

static status take_list(const cloud_stream *s, const char *rest, take_word *take, pcd *p)
{
    status st = OK;
    char word[WORD];
    int n = 0;
    while (cloud_word(&rest, word, sizeof word)) {
        if (n == (take == take_name ? MOST_FIELDS : p->nfield)) {
            TRY(stream_fail(s, "more entries than fields"));
        }
        TRY(take(s, word, n, p));
        n++;
    }
    p->nfield = take == take_name ? n : p->nfield;
    if (n < p->nfield) {
        TRY(stream_fail(s, "%d entries for %d fields", n, p->nfield));
    }

done:
    return st;
}

static status take_number(const cloud_stream *s, const char *rest, uint64_t *value)
{
    char word[WORD];
    const bool good = cloud_word(&rest, word, sizeof word) && cloud_count(word, value);
    return good ? OK : stream_fail(s, "a whole number is missing");
}

static status take_form(const cloud_stream *s, const char *rest, pcd *p)
{
    static const char *const forms[] = {"ascii", "binary", "binary_compressed"};
    char word[WORD];
    (void)cloud_word(&rest, word, sizeof word);
    for (int i = PCD_TEXT; i <= PCD_PACKED; i++) {
        if (strcmp(word, forms[i]) == 0) {
            p->form = i;
            return OK;
        }
    }
    return stream_fail(s, "DATA %s: ascii, binary and binary_compressed are read", word);
}

static status take_line(const cloud_stream *s, const char *line, pcd *p)
{
    static const struct {
        const char *name;
        take_word *take;
    } lists[] = {{"FIELDS", take_name},
                 {"SIZE", take_size},
                 {"TYPE", take_type},
                 {"COUNT", take_count},
                 {"COLUMNS", take_name}};
    char word[WORD];
    const char *rest = line;
    if (!cloud_word(&rest, word, sizeof word) || word[0] == '#') {
        return OK;
    }
    for (size_t i = 0; i < sizeof lists / sizeof *lists; i++) {
        if (strcmp(word, lists[i].name) == 0) {
            return take_list(s, rest, lists[i].take, p);
        }
    }
    if (strcmp(word, "DATA") == 0) {
        return take_form(s, rest, p);
    }
    uint64_t *value = strcmp(word, "WIDTH") == 0    ? &p->width
                      : strcmp(word, "HEIGHT") == 0 ? &p->height
                      : strcmp(word, "POINTS") == 0 ? &p->points
                                                    : NULL;
    if (value) {
        return take_number(s, rest, value);
    }
    // where the scanner stood does not move the points
    const bool known = strcmp(word, "VERSION") == 0 || strcmp(word, "VIEWPOINT") == 0;
    return known ? OK : stream_fail(s, "'%s' is no word of a PCD header", word);
}

static status find_axes(const cloud_stream *s, pcd *p)
{
    for (int d = 0; d < 3; d++) {
        const char axis[2] = {(char)('x' + d), 0};
        p->axis[d] = -1;
        for (int i = 0; i < p->nfield; i++) {
            p->axis[d] = strcmp(p->name[i], axis) == 0 ? i : p->axis[d];
        }
        const int i = p->axis[d];
        if (i < 0 || p->count[i] != 1) {
            return stream_fail(s, "no field '%s'", axis);
        }
        if (p->type[i] == 'F' && p->size[i] < 4) {
            return stream_fail(s, "field '%s': no float has %d bytes", axis, (int)p->size[i]);
        }
    }
    return OK;
}

static status read_header(cloud_stream *s, pcd *p)
{
    status st = OK;
    char *line = NULL;
    p->form = PCD_UNKNOWN;
    for (int i = 0; i < MOST_LINES && p->form == PCD_UNKNOWN; i++) {
        TRY(stream_line(s, &line));
        if (!line) {
            break;
        }
        TRY(take_line(s, line, p));
    }
    if (p->form == PCD_UNKNOWN) {
        TRY(stream_fail(s, "the header has no DATA"));
    }
    TRY(find_axes(s, p));
    if (p->points == 0 && p->width <= CLOUD_MOST_POINTS && p->height <= CLOUD_MOST_POINTS) {
        p->points = p->width * (p->height > 0 ? p->height : 1);
    }

done:
    return st;
}

static scalar_kind kind_of(const pcd *p, int field)
{
    static const scalar_kind whole[2][4] = {{SCALAR_I8, SCALAR_I16, SCALAR_I32, SCALAR_I64},
                                            {SCALAR_U8, SCALAR_U16, SCALAR_U32, SCALAR_U64}};
    const uint64_t size = p->size[field];
    if (p->type[field] == 'F') {
        return size == 4 ? SCALAR_F32 : SCALAR_F64;
    }
    return whole[p->type[field] == 'U'][size == 1 ? 0 : size == 2 ? 1 : size == 4 ? 2 : 3];
}

// bytes, or words, in front of a field
static uint64_t before(const pcd *p, int field, bool words)
{
    uint64_t sum = 0;
    for (int i = 0; i < field; i++) {
        sum += p->count[i] * (words ? 1 : p->size[i]);
    }
    return sum;
}

static status read_text(cloud_stream *s, const pcd *p, cloud_builder *b)
{
    status st = OK;
    char *line = NULL;
    int column[3];
    for (int d = 0; d < 3; d++) {
        column[d] = (int)before(p, p->axis[d], true);
    }
    for (uint64_t i = 0; i < p->points; i++) {
        double xyz[3];
        TRY(stream_row(s, i, p->points, &line));
        TRY(cloud_row(s, line, column, xyz));
        builder_put(b, xyz);
    }

done:
    return st;
}

static status read_bytes(cloud_stream *s, const pcd *p, cloud_builder *b)
{
    status st = OK;
    const uint64_t stride = before(p, p->nfield, false);
    const unsigned char *bytes = NULL;
    if (stride > STREAM_ROOM) {
        TRY(stream_fail(s, "a point of %llu bytes", (unsigned long long)stride));
    }
    for (uint64_t i = 0; i < p->points; i++) {
        double xyz[3];
        TRY(stream_bytes(s, (size_t)stride, &bytes));
        for (int d = 0; d < 3; d++) {
            const int field = p->axis[d];
            xyz[d] = scalar_read(bytes + before(p, field, false), kind_of(p, field), false);
        }
        builder_put(b, xyz);
    }

done:
    return st;
}

// Where the unpacked bytes go: columns one after the other.
typedef struct columns {
    cloud_builder *b;
    uint64_t at;              // bytes unpacked so far
    uint64_t begin[3], count; // of the columns of x, y and z; points
    size_t size[3];
    scalar_kind kind[3];
    unsigned char number[3][8]; // one that is not whole yet
} columns;

static void take_byte(columns *c, int d, uint64_t from, unsigned char byte)
{
    c->number[d][from % c->size[d]] = byte;
    if (from % c->size[d] == c->size[d] - 1) {
        c->b->cloud.p[from / c->size[d]][d] = scalar_read(c->number[d], c->kind[d], false);
    }
}

static void take_bytes(void *context, const unsigned char *bytes, size_t count)
{
    columns *c = context;
    for (int d = 0; d < 3; d++) {
        const uint64_t end = c->begin[d] + c->count * c->size[d];
        const uint64_t from = c->at > c->begin[d] ? c->at : c->begin[d];
        const uint64_t to = c->at + count < end ? c->at + count : end;
        for (uint64_t i = from; i < to; i++) {
            take_byte(c, d, i - c->begin[d], bytes[i - c->at]);
        }
    }
    c->at += count;
}

static status read_packed(cloud_stream *s, const pcd *p, cloud_builder *b)
{
    status st = OK;
    const unsigned char *bytes = NULL;
    columns c = {.b = b, .count = p->points};
    for (int d = 0; d < 3; d++) {
        c.begin[d] = p->points * before(p, p->axis[d], false);
        c.size[d] = (size_t)p->size[p->axis[d]];
        c.kind[d] = kind_of(p, p->axis[d]);
    }
    TRY(stream_bytes(s, 8, &bytes));
    const uint64_t packed = (uint64_t)scalar_read(bytes, SCALAR_U32, false);
    const uint64_t whole = (uint64_t)scalar_read(bytes + 4, SCALAR_U32, false);
    if (whole != p->points * before(p, p->nfield, false)) {
        TRY(stream_fail(s, "%llu points do not take the %llu bytes that it unpacks to",
                        (unsigned long long)p->points, (unsigned long long)whole));
    }
    TRY(cloud_lzf(s, packed, whole, take_bytes, &c));
    b->cloud.count = (size_t)p->points;
    builder_clean(b);

done:
    return st;
}

status cloud_pcd(cloud_stream *s, cloud_builder *b, cloud_report *report)
{
    static const char *const names[] = {"PCD, text", "PCD, binary", "PCD, binary compressed"};
    // 3 bytes of LZF stand for at most 264
    enum { PACKING = 88 };
    status st = OK;
    pcd *p = NULL;
    TRY(TAKE(p, 1));
    TRY(read_header(s, p));
    (void)snprintf(report->kind, sizeof report->kind, "%s", names[p->form]);
    const uint64_t stride = before(p, p->nfield, false);
    const uint64_t least = p->form == PCD_TEXT    ? 2 * before(p, p->nfield, true)
                           : p->form == PCD_BYTES ? stride
                                                  : stride / PACKING;
    TRY(builder_expect(b, s, p->points, least));
    if (p->form != PCD_TEXT) {
        stream_in_bytes(s);
    }
    TRY(p->form == PCD_TEXT    ? read_text(s, p, b)
        : p->form == PCD_BYTES ? read_bytes(s, p, b)
                               : read_packed(s, p, b));

done:
    free(p);
    return st;
}
