// measure/cloud_parts.h
// What the readers of point clouds share: points as they come in, binary numbers, numbers in text.
#pragma once

#include "measure/cloud_read.h"
#include "measure/cloud_stream.h"

// Points on their way in; the file's unit is applied here.
typedef struct cloud_builder {
    point_cloud cloud;
    size_t room;
    size_t dropped;
    double unit; // [m]
} cloud_builder;

// Room for `count` points that the file says it has; ERR_FILE where that is none, more than
// CLOUD_MOST_POINTS, or more than its bytes hold at `least` bytes a point.
status builder_expect(cloud_builder *b, const cloud_stream *s, uint64_t count, uint64_t least);
status builder_grow(cloud_builder *b, const cloud_stream *s); // twice the room

// A point in the file's unit; b->room must hold it.
void builder_put(cloud_builder *b, const double xyz[3]);

// Leaves out what is not finite among points that were written straight into the cloud.
void builder_clean(cloud_builder *b);

// --- binary numbers

typedef enum scalar_kind {
    SCALAR_I8,
    SCALAR_U8,
    SCALAR_I16,
    SCALAR_U16,
    SCALAR_I32,
    SCALAR_U32,
    SCALAR_I64,
    SCALAR_U64,
    SCALAR_F32,
    SCALAR_F64,
    SCALAR_NONE,
} scalar_kind;

size_t scalar_size(scalar_kind k);
double scalar_read(const unsigned char *bytes, scalar_kind k, bool big_endian);

// --- text

// A number at *text, which moves behind it: decimal, nan or inf in any letters; comma: a decimal
// comma too. Right to a unit in the last place. False where there is none.
bool cloud_number(const char **text, bool comma, double *value);

// The next word of a line that is parted by blanks, at most room - 1 letters of it; false: none.
bool cloud_word(const char **text, char *word, size_t room);

// A whole number of digits only, below 2^63.
bool cloud_count(const char *word, uint64_t *count);

// x, y and z from three columns (from 0) of a line parted by blanks.
status cloud_row(const cloud_stream *s, const char *line, const int column[3], double xyz[3]);

// --- the formats; the stream stands at the file's begin

status cloud_ply(cloud_stream *s, cloud_builder *b, cloud_report *report);
status cloud_pcd(cloud_stream *s, cloud_builder *b, cloud_report *report);
// unit NAN: not said by the user
status cloud_text(cloud_stream *s, double unit, cloud_builder *b, cloud_report *report);

// cloud_lzf.c: `count` bytes of PCD's compressed data, packed into `packed` bytes of the stream,
// are handed on piece by piece in their order.
typedef void lzf_take(void *context, const unsigned char *bytes, size_t count);
status cloud_lzf(cloud_stream *s, uint64_t packed, uint64_t count, lzf_take *take, void *context);
