// io/arena.h
// Many small pieces of zeroed memory that live and die together.
#pragma once

#include "base/status.h"

#include <stddef.h>

typedef struct arena arena;

status arena_make(arena **out);
void arena_free(arena *a); // NULL is fine

// ERR_RESOURCE when there is not enough; a count of 0 gives a valid pointer to nothing.
status arena_take(arena *a, void **out, size_t count, size_t size);
status arena_copy(arena *a, const char *text, size_t length, const char **out); // NUL added

// ARENA_TAKE(a, p, n): p becomes n zeroed items of the arena
#define ARENA_TAKE(a, pointer, count)                                                              \
    arena_take((a), (void **)&(pointer), (count), sizeof *(pointer))
