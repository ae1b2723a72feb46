// io/yaml_door.h
// libyaml's one door: the events of a text become a tree of plain nodes in the config's arena.
#pragma once

#include "io/case_tree.h"

// override: which --set the text is the value of, -1 for the file. *root is NULL where the text
// holds nothing. ERR_INPUT for what YAML refuses, and for what a case does without: anchors,
// aliases, tags, several documents, keys that are lists or maps, a key given twice, more than
// CONFIG_MAX_DEPTH levels or CONFIG_MAX_NODES values.
status yaml_read(config *cfg, const char *text, size_t length, int override, node **root);
