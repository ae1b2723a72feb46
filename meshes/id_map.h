// meshes/id_map.h
// From a file's own numbers of things to 0, 1, 2, ...
#pragma once

#include "base/status.h"

#include <stdint.h>

typedef struct id_pair {
    int64_t id;
    int index;
} id_pair;

typedef struct id_map {
    int count;
    id_pair *sorted; // [count] by id
    int64_t least;   // of the ids
    int ntable;
    int *table; // [ntable] index of least + i, -1 where there is none; NULL: ids lie too far apart
} id_map;

// *twice: an index whose id came before, -1 where all differ.
status id_map_make(int count, const int64_t *ids, id_map *out, int *twice);
void id_map_free(id_map *m);

// -1: there is none.
int id_map_find(const id_map *m, int64_t id);
