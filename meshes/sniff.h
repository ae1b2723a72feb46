// meshes/sniff.h
// What a file is by its first bytes, whatever its name says.
#pragma once

#include "base/input_file.h"

enum { SNIFF_WORDS = 96 };

// "a PNG image", "a program", "text that begins with 'Point(1) = ...'": for messages, returns
// `words`.
const char *sniff_words(const input_file *f, char words[SNIFF_WORDS]);
