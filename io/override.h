// io/override.h
// --set KEY=VALUE: laid over the tree of the case file before anything is read from it.
#pragma once

#include "io/case_tree.h"

// Applies cfg->overrides in their order. A key replaces the one of the same name in another unit;
// maps that are missing are made; an entry of a list goes by its number from 0, or by its `name`.
// The value is YAML: a number, a text, or [a, b] and {a: b}.
status override_apply(config *cfg);
