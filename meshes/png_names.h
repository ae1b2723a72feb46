// The files of an image or of a stack: a name, or a pattern with one %d.
#pragma once

#include "meshes/drawing.h"

enum { PNG_MOST_SLICES = 100000 };

typedef struct png_names {
    key_text file;
    bool stack;
    int begin, end; // bytes of the file's name that the conversion takes
    int width;      // digits at least
    bool zeros;     // leading zeros, else blanks
    int first, count;
} png_names;

// Counts the files of a stack. ERR_INPUT for a pattern that is none, a gap or no file at all.
status png_names_find(const png_spec *spec, const char *directory, png_names *out);

// The name of file `i` = 0..count-1, the caller's to free.
status png_names_at(const png_names *names, int i, char **out);
