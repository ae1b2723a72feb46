// io/config_defaults.h
// What a case left open, and what was taken instead.
#pragma once

#include "io/config.h"

// map: the key of the case's part, "rod"; key, words: "frame", "gc".
typedef void config_default(void *self, const char *map, const char *key, const char *words);

// For every part of the case, in the order of the tables: the keys of its own that the case could
// have, does not, and that have a default in words. Parts that the case lacks are left out.
void config_defaults(const config *cfg, const key_table *root, config_default *tell, void *self);
