// io/name_set.h
// Which names stand in which map: finds a duplicate key in constant time.
#pragma once

#include "io/case_tree.h"

typedef struct name_set {
    size_t size, used; // size is a power of 2
    struct name_slot *slots;
} name_set;

// *before is the entry of `map` that has the key of `entry` already; NULL when there is none, and
// `entry` is added.
status name_set_add(name_set *set, const node *map, const node *entry, const node **before);
void name_set_free(name_set *set);
