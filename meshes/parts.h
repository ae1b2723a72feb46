// meshes/parts.h
// Which part of a file is of which material: by the case's `parts`, else by a material of the
// part's own name.
#pragma once

#include "base/input_file.h"
#include "meshes/drawing.h"

enum { PART_NONE = -1, PART_UNKNOWN = -2 };

typedef struct part_table {
    const char *what; // "physical group", "layer", "body": for messages
    int count;
    const part_spec *spec; // [count]
    int *material;         // [count] index, or PART_NONE
    bool *used;            // [count]
    int nmaterial;
    const material *materials;
} part_table;

// ERR_INPUT, with its place, where an entry names a material that the case does not have, where two
// entries name the same part, or where a colour is none.
status parts_make(const char *what, const key_list *parts, const drawing_request *request,
                  part_table *out);
void parts_free(part_table *t);

// The material's index, PART_NONE or PART_UNKNOWN.
int part_by_name(part_table *t, const char *name);
int part_by_colour(part_table *t, const unsigned char rgb[3]);

// ERR_FILE, with the names that are near: the part belongs to no material.
status part_unknown(const part_table *t, const input_file *file, long line, const char *name);

// ERR_INPUT, with its place, where an entry of `parts` met nothing in the file; names: what the
// file has.
status parts_all_used(const part_table *t, int nname, const char *const *names);

// Whether "#rrggbb" is a colour.
bool part_read_colour(const char *text, unsigned char rgb[3]);
