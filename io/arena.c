// io/arena.c
#include "io/arena.h"

#include "base/memory.h"

#include <stdalign.h>
#include <stdint.h>
#include <string.h>

// a small case takes one chunk; a large one few, since each is twice the one before
enum { FIRST_CHUNK = 16 << 10, LAST_CHUNK = 4 << 20, ALIGNMENT = alignof(max_align_t) };

typedef struct chunk {
    struct chunk *next;
    char *memory;
    size_t size, used;
} chunk;

struct arena {
    chunk *chunks; // the newest first
    size_t next_size;
};

status arena_make(arena **out)
{
    const status st = memory_take((void **)out, 1, sizeof **out);
    if (st == OK) {
        (*out)->next_size = FIRST_CHUNK;
    }
    return st;
}

void arena_free(arena *a)
{
    while (a && a->chunks) {
        chunk *c = a->chunks;
        a->chunks = c->next;
        free(c->memory);
        free(c);
    }
    free(a);
}

static status add_chunk(arena *a, size_t least)
{
    status st = OK;
    chunk *c = NULL;
    TRY(TAKE(c, 1));
    c->size = least > a->next_size ? least : a->next_size;
    TRY(TAKE(c->memory, c->size));
    if (a->next_size < LAST_CHUNK) {
        a->next_size *= 2;
    }
    c->next = a->chunks;
    a->chunks = c;
    c = NULL;

done:
    free(c);
    return st;
}

status arena_take(arena *a, void **out, size_t count, size_t size)
{
    if (size > 0 && count > (SIZE_MAX / 2) / size) {
        return status_fail(ERR_RESOURCE, "out of memory: %zu items of %zu bytes", count, size);
    }
    const size_t bytes = (count * size + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT;
    if (!a->chunks || a->chunks->size - a->chunks->used < bytes) {
        const status st = add_chunk(a, bytes);
        if (st != OK) {
            return st;
        }
    }
    *out = a->chunks->memory + a->chunks->used;
    a->chunks->used += bytes;
    return OK;
}

status arena_copy(arena *a, const char *text, size_t length, const char **out)
{
    char *copy = NULL;
    const status st = arena_take(a, (void **)&copy, length + 1, 1);
    if (st == OK) {
        memcpy(copy, text, length);
        *out = copy;
    }
    return st;
}
