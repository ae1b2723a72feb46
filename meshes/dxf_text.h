// meshes/dxf_text.h
// The lines of an ASCII DXF file: pairs of a group code and a value, gathered into entities.
#pragma once

#include "base/input_file.h"

enum { DXF_NAME = 64 };

typedef struct dxf_text {
    const input_file *file;
    size_t at;
    long line; // of the pair's code, from 1
    int code;
    const char *value; // [length], not ended by 0
    size_t length;
} dxf_text;

// The next pair. ERR_FILE where the file ends before its EOF, or where a code is none.
status dxf_next(dxf_text *t);

// Whether the pair is this code with this word.
bool dxf_is(const dxf_text *t, int code, const char *word);

// The value as a number. ERR_FILE where it is none.
status dxf_number(const dxf_text *t, double *out);

// The value as a text; longer ones are cut.
void dxf_word(const dxf_text *t, char out[DXF_NAME]);

typedef struct dxf_pair {
    int code;
    double value;
} dxf_pair;

// Everything between one `0` and the next that a curve may need.
typedef struct dxf_entity {
    char kind[DXF_NAME], layer[DXF_NAME];
    long line;
    int npair, room;
    dxf_pair *pair; // of the codes that hold numbers, in order
} dxf_entity;

// The entity that starts at the current pair; the text stands at the next `0` then. The entity is
// used again for the next one; free it at last.
status dxf_entity_read(dxf_text *t, dxf_entity *e);
void dxf_entity_free(dxf_entity *e);

// The first value of a code, or what stands for none.
double dxf_get(const dxf_entity *e, int code, double otherwise);
int dxf_get_int(const dxf_entity *e, int code, int otherwise);
int dxf_count(const dxf_entity *e, int code);

// ERR_FILE where one of these codes is missing; ended by 0.
status dxf_need(const dxf_text *t, const dxf_entity *e, const int *codes);
