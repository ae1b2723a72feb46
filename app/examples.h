// app/examples.h
// The cases of the repository's cases/, carried by the program; written by cmake/embed.cmake when
// it is built.
#pragma once

#include <stddef.h>

typedef struct example {
    const char *name; // NULL ends the list
    const char *text; // [length], and a NUL after it
    size_t length;
} example;

extern const example examples[];
