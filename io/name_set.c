// io/name_set.c
#include "io/name_set.h"

#include "base/memory.h"

#include <stdint.h>
#include <string.h>

typedef struct name_slot {
    const node *map, *entry; // entry NULL: free
} name_slot;

// FNV-1a over the map's address and the key
static size_t hash(const node *map, const char *key)
{
    uint64_t h = 14695981039346656037u ^ (uint64_t)(uintptr_t)map;
    h *= 1099511628211u;
    for (; *key; key++) {
        h = (h ^ (unsigned char)*key) * 1099511628211u;
    }
    return (size_t)(h ^ h >> 29);
}

// the slot that holds this key, or the free one where it belongs
static name_slot *find(const name_set *set, const node *map, const char *key)
{
    for (size_t i = hash(map, key);; i++) {
        name_slot *slot = &set->slots[i & (set->size - 1)];
        if (!slot->entry || (slot->map == map && strcmp(slot->entry->key, key) == 0)) {
            return slot;
        }
    }
}

static status grow(name_set *set)
{
    name_set wider = {.size = set->size ? 2 * set->size : 64, .used = set->used};
    const status st = TAKE(wider.slots, wider.size);
    if (st != OK) {
        return st;
    }
    for (size_t i = 0; i < set->size; i++) {
        if (set->slots[i].entry) {
            *find(&wider, set->slots[i].map, set->slots[i].entry->key) = set->slots[i];
        }
    }
    free(set->slots);
    *set = wider;
    return OK;
}

status name_set_add(name_set *set, const node *map, const node *entry, const node **before)
{
    // at most half full, so that a search ends after a few slots
    if (2 * (set->used + 1) > set->size) {
        const status st = grow(set);
        if (st != OK) {
            return st;
        }
    }
    name_slot *slot = find(set, map, entry->key);
    *before = slot->entry;
    if (!slot->entry) {
        *slot = (name_slot){map, entry};
        set->used++;
    }
    return OK;
}

void name_set_free(name_set *set)
{
    free(set->slots);
    *set = (name_set){0};
}
