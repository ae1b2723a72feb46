// io/annotate.h
// A case's text for whoever meets its keys for the first time: every key gets a comment.
#pragma once

#include "base/key.h"
#include "base/status.h"

#include <stddef.h>

enum { ANNOTATE_WIDTH = 128 }; // columns that a comment may reach

// The text with the meaning of each key at its first use: behind a key that has a line to itself,
// above the line where several stand in braces. Where the text says something behind such a key
// itself, that stands alone. Nothing but comments is added: what is read stays the same. *out is
// the caller's, with a NUL at its end. ERR_INPUT for what is no YAML.
status config_annotate(const char *path, const char *text, const key_table *root, char **out);
