// io/case_tree.h
// Inside of io: a case file as a tree of plain nodes, and the config that owns it.
#pragma once

#include "io/arena.h"
#include "io/config.h"
#include "io/expression.h"

typedef enum node_kind { NODE_SCALAR, NODE_LIST, NODE_MAP } node_kind;

typedef struct node node;
struct node {
    node_kind kind;
    int count;       // entries of a list or map
    mark at;         // of the value
    mark key_at;     // of the key, in a map
    const char *key; // in a map, else NULL
    node *next;      // in the same list or map
    union {
        node *first;
        const char *text;
    };
    int text_column; // scalar: the column of the text's first character; 0 where text and file do
                     // not run side by side
    bool plain;      // scalar: not in quotes
};

// A place inside the value of an override has the line OVERRIDE_LINE + index of the override;
// override -1 is the file.
enum { OVERRIDE_LINE = 1 << 28 };

// The line of what is said about the file as a whole, which has no place inside of it.
enum { WHOLE_FILE_LINE = -1 };

static inline mark case_mark(int override, mark in_text)
{
    return (mark){override < 0 ? in_text.line : OVERRIDE_LINE + override, in_text.column};
}

struct config {
    char *path;
    char *text; // as read
    size_t length;
    int noverride;
    const char **overrides;
    arena *memory;
    calculator *arithmetic;
    node *root;
    int nnode; // of the file and all overrides
    double length_m;
    bool has_length;
};

// A text for a message: cut to a readable length. Control characters are taken out by config_fail.
typedef struct short_text {
    char a[64];
} short_text;
short_text shortened(const char *text);
