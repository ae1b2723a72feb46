// reports/passage.h
// The two ways between a run_result and the store, described once: the same tables write and read,
// so that they cannot disagree. What is read is checked: shapes against the counts that came first,
// numbers and choices against limits.
#pragma once

#include "base/mesh.h"
#include "io/store.h"

#include <stdbool.h>
#include <stddef.h>

typedef struct passage {
    store *store;
    bool reading;
    const char *path; // for messages
} passage;

typedef enum column_kind {
    COLUMN_REAL,     // finite, and within what its unit allows (passage.c)
    COLUMN_POSITIVE, // a COLUMN_REAL above 0
    COLUMN_KNOWN,    // a COLUMN_REAL, or NaN where it is not known
    COLUMN_ANY,      // a number that may also be NaN or infinite: an estimate, the other side of a
                     // comparison
    COLUMN_INT,
    COLUMN_FLAG, // bool
    COLUMN_TEXT, // char[shape[0]]; every item its own dataset
} column_kind;

enum { COLUMN_MAX_RANK = 3, PASSAGE_MAX_NAME = 160 };

// One member of a struct. In the store its name stands below the group's, behind the index where it
// is a text.
typedef struct column {
    const char *name; // with its unit
    int kind;
    const char *unit;
    size_t offset;
    int rank; // of one item; 0: a number
    size_t shape[COLUMN_MAX_RANK];
    int max; // COLUMN_INT: from 0 to max
} column;

// n structs of `stride` bytes from `base`: every column is one array [n][shape].
typedef struct column_rows {
    void *base;
    size_t n, stride;
    bool single; // one struct; no leading dimension
    bool behind; // the members are pointers to the items
} column_rows;

status passage_columns(const passage *p, const char *group, int ncolumn, const column *columns,
                       column_rows rows);

// A count between least and most; what is read is held against them.
status passage_count(const passage *p, const char *name, int least, int most, int *n);

// Reading: *array becomes n zeroed items. Writing: nothing.
status passage_room(const passage *p, void **array, size_t n, size_t size);

// A text; reading: *text is the caller's to free, a NUL added.
status passage_text(const passage *p, const char *name, char **text, size_t *length);

// A text in a buffer of `size` bytes.
status passage_words(const passage *p, const char *name, char *text, size_t size);

// A mesh of dimension `dim`, of some size in each direction; nodes within the mesh, materials
// within nmaterial. nnode 0: there is none.
status passage_mesh(const passage *p, const char *group, int dim, int nmaterial, mesh *m);

// GROUP/TAIL, cut where it would be too long.
typedef struct passage_name {
    char text[PASSAGE_MAX_NAME];
} passage_name;
passage_name passage_join(const char *group, const char *tail);

// ERR_FILE: "PATH: damaged: NAME WORDS"
status passage_damaged(const passage *p, const char *name, const char *words);
