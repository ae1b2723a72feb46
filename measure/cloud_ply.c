// measure/cloud_ply.c
// Of a PLY file only the element with x, y and z is read; those in front of it are passed over,
// those behind it never reached.
#include "measure/ply.h"

#include "base/memory.h"

#include <stdio.h>
#include <string.h>

// One element with lists, by the byte; xyz NULL: passed over.
static status walk_lists(cloud_stream *s, const ply *p, const ply_element *e, double *xyz)
{
    status st = OK;
    const bool big = p->form == PLY_BIG;
    const unsigned char *bytes = NULL;
    for (int i = 0; i < e->nproperty; i++) {
        const ply_property *q = &p->property[e->first + i];
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

static status pass_over(cloud_stream *s, const ply *p, const ply_element *e)
{
    status st = OK;
    const uint64_t stride = ply_stride(p, e);
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
static status columns_of_line(const cloud_stream *s, const ply *p, const ply_element *e,
                              const char *line, int column[3])
{
    char word[PLY_WORD];
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

static status read_text(cloud_stream *s, const ply *p, const ply_element *e, cloud_builder *b)
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

static status read_bytes(cloud_stream *s, const ply *p, const ply_element *e, cloud_builder *b)
{
    status st = OK;
    const size_t stride = (size_t)ply_stride(p, e);
    size_t offset[3] = {0};
    scalar_kind kind[3];
    const unsigned char *bytes = NULL;
    double xyz[3] = {0};
    for (int d = 0; d < 3; d++) {
        const ply_element before = {.first = e->first, .nproperty = e->axis[d]};
        offset[d] = (size_t)ply_stride(p, &before);
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
    TRY(ply_read_header(s, p));
    TRY(find_points(s, p, &which));
    (void)snprintf(report->kind, sizeof report->kind, "%s", names[p->form]);
    const ply_element *e = &p->element[which];
    // a text takes a digit and a blank or line's end each
    const uint64_t least = p->form == PLY_TEXT ? 2 * (uint64_t)e->nproperty : ply_stride(p, e);
    TRY(builder_expect(b, s, e->count, least));
    for (int i = 0; i < which; i++) {
        TRY(pass_over(s, p, &p->element[i]));
    }
    TRY(p->form == PLY_TEXT ? read_text(s, p, e, b) : read_bytes(s, p, e, b));

done:
    free(p);
    return st;
}
