// measure/ply.h
// PLY files: a header of elements with properties, then their values as text or bytes.
#pragma once

#include "measure/cloud_parts.h"

enum { PLY_ELEMENTS = 64, PLY_PROPERTIES = 256, PLY_WORD = 64 };

typedef struct ply_property {
    scalar_kind kind;
    scalar_kind length; // of a list's length; SCALAR_NONE: no list
} ply_property;

typedef struct ply_element {
    char name[PLY_WORD];
    uint64_t count;
    int first, nproperty; // in ply.property
    int axis[3];          // which of its properties is x, y, z; -1
    int corners;          // which is the list of a face's vertices; -1
    bool lists;
} ply_element;

typedef struct ply {
    enum { PLY_UNKNOWN, PLY_TEXT, PLY_LITTLE, PLY_BIG } form;
    int nelement, nproperty;
    ply_element element[PLY_ELEMENTS];
    ply_property property[PLY_PROPERTIES];
} ply;

// Reads to the header's end; from there on places are told in bytes where the values are.
status ply_read_header(cloud_stream *s, ply *p);

// bytes of one element without lists; what lists take at least
uint64_t ply_stride(const ply *p, const ply_element *e);

// The next element's values, in their order: value `k` of `count` of a property from 0, of what is
// no list 0 of 1. An error that `take` returns ends it.
typedef status ply_take(void *context, int property, uint64_t k, uint64_t count, double value);
status ply_row(cloud_stream *s, const ply *p, const ply_element *e, ply_take *take, void *context);
