// measure/cloud_read.c
#include "measure/cloud_read.h"

#include "measure/cloud_parts.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// no bench is larger [m]; squares of what lies within stay far from overflow
static const double FARTHEST = 1e4;

static status set_room(cloud_builder *b, size_t room)
{
    double(*wider)[3] = realloc(b->cloud.p, room * sizeof *wider);
    if (!wider) {
        return status_fail(ERR_RESOURCE, "out of memory for %zu points", room);
    }
    b->cloud.p = wider;
    b->room = room;
    return OK;
}

status builder_expect(cloud_builder *b, const cloud_stream *s, uint64_t count, uint64_t least)
{
    if (count == 0) {
        return stream_fail(s, "it has no points");
    }
    if (count > CLOUD_MOST_POINTS) {
        return stream_fail(s, "%llu points; at most %d are read", (unsigned long long)count,
                           CLOUD_MOST_POINTS);
    }
    if (count * least > s->size) {
        return stream_fail(s, "%llu points take %llu bytes or more, but the file has %llu",
                           (unsigned long long)count, (unsigned long long)(count * least),
                           (unsigned long long)s->size);
    }
    return set_room(b, (size_t)count);
}

status builder_grow(cloud_builder *b, const cloud_stream *s)
{
    const size_t most = CLOUD_MOST_POINTS, twice = b->room > 0 ? 2 * b->room : 4096;
    if (b->room == most) {
        return stream_fail(s, "more than %zu points", most);
    }
    return set_room(b, twice < most ? twice : most);
}

static bool is_sound(const double p[3])
{
    // false for NaN
    return fabs(p[0]) <= FARTHEST && fabs(p[1]) <= FARTHEST && fabs(p[2]) <= FARTHEST;
}

void builder_put(cloud_builder *b, const double xyz[3])
{
    double *p = b->cloud.p[b->cloud.count];
    for (int d = 0; d < 3; d++) {
        p[d] = xyz[d] * b->unit;
    }
    if (is_sound(p)) {
        b->cloud.count++;
    } else {
        b->dropped++;
    }
}

void builder_clean(cloud_builder *b)
{
    const size_t count = b->cloud.count;
    b->cloud.count = 0;
    for (size_t i = 0; i < count; i++) {
        const double xyz[3] = {b->cloud.p[i][0], b->cloud.p[i][1], b->cloud.p[i][2]};
        builder_put(b, xyz);
    }
}

static cloud_format format_of(const unsigned char *bytes, size_t count)
{
    static const struct {
        const char *words;
        cloud_format format;
    } known[] = {{"ply\n", CLOUD_PLY},    {"ply\r", CLOUD_PLY}, {"# .PCD", CLOUD_PCD},
                 {"VERSION ", CLOUD_PCD}, {"#.PCD", CLOUD_PCD}, {"FIELDS ", CLOUD_PCD}};
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        const size_t n = strlen(known[i].words);
        if (count >= n && memcmp(bytes, known[i].words, n) == 0) {
            return known[i].format;
        }
    }
    for (size_t i = 0; i < count; i++) {
        if (bytes[i] == 0 || (bytes[i] < 32 && !strchr("\t\r\n", bytes[i]))) {
            return CLOUD_NONE;
        }
    }
    return CLOUD_TEXT;
}

static status read_format(cloud_stream *s, double unit, cloud_builder *b, cloud_report *report)
{
    status st = OK;
    const unsigned char *bytes = NULL;
    size_t count = 0;
    TRY(stream_peek(s, 512, &bytes, &count));
    switch (format_of(bytes, count)) {
    case CLOUD_PLY:
        TRY(cloud_ply(s, b, report));
        break;
    case CLOUD_PCD:
        TRY(cloud_pcd(s, b, report));
        break;
    case CLOUD_TEXT:
        TRY(cloud_text(s, unit, b, report));
        break;
    default:
        TRY(stream_fail(s, "it is no point cloud: neither PLY nor PCD nor text with columns"));
    }

done:
    return st;
}

// what was taken as room for more points goes back
static void trim(cloud_builder *b)
{
    const size_t count = b->cloud.count;
    if (count > 0 && count < b->room) {
        double(*less)[3] = realloc(b->cloud.p, count * sizeof *less);
        b->cloud.p = less ? less : b->cloud.p;
    }
}

status cloud_read(const char *path, const cloud_read_options *options, point_cloud *out,
                  cloud_report *report)
{
    status st = OK;
    cloud_stream s = {.fd = -1};
    cloud_builder b = {.unit = isnan(options->unit) ? 1e-3 : options->unit};
    *report = (cloud_report){0};

    TRY(stream_open(path, &s));
    s.progress = options->progress;
    s.context = options->context;
    TRY(read_format(&s, options->unit, &b, report));
    report->read = b.cloud.count + b.dropped;
    report->dropped = b.dropped;
    report->unit = b.unit;
    if (b.cloud.count == 0) {
        s.line = 0;
        s.loaded = s.begin = s.end = 0; // of the whole file
        TRY(stream_fail(
            &s, report->read == 0 ? "it has no points" : "none of its %zu points is a finite place",
            report->read));
    }
    trim(&b);
    *out = b.cloud;
    b.cloud = (point_cloud){0};

done:
    point_cloud_free(&b.cloud);
    stream_close(&s);
    return st;
}
