// app/examples.h
// The cases of the repository's cases/, carried by the program with the files that they read;
// written by cmake/embed.cmake when it is built.
#pragma once

#include <stddef.h>

typedef struct example_file {
    const char *name; // beside the case; NULL ends the list
    const char *bytes;
    size_t length;
} example_file;

typedef struct example {
    const char *name; // NULL ends the list
    const char *text; // [length], and a NUL after it
    size_t length;
    const example_file *files; // NULL: needs none
} example;

extern const example examples[];
