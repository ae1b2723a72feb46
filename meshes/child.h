// meshes/child.h
// Work of a library that may crash or hang, in a child process of its own: a crash, a word on the
// terminal, memory or time without end stay there, and each piece of work starts from the same
// state.
#pragma once

#include "base/status.h"

#include <stddef.h>
#include <stdint.h>

// one array of the answer: where its pointer is, entries, bytes of an entry
typedef struct child_part {
    void **at;
    int64_t count;
    size_t size;
} child_part;

enum { CHILD_MOST_PARTS = 12 };

typedef struct child_job {
    const char *what;   // "the free mesher (gmsh)": for messages
    int seconds;        // until it is stopped
    size_t memory;      // it may take beyond what this process has [bytes]; 0: any
    bool sealed;        // it writes no file, starts no program, opens no connection
    status when_killed; // what a crash of it says of its input
    void *request;
    status (*work)(void *request, void *answer);
    // The answer is a struct of plain numbers and pointers to arrays; `list` tells the arrays,
    // their counts by the struct's own numbers, and returns how many.
    size_t answer_size;
    int (*list)(void *answer, child_part parts[CHILD_MOST_PARTS]);
} child_job;

// `answer` begins zeroed; its arrays are the caller's to free (child_answer_free), also after a
// failure. What `work` returned, with its message; when_killed where it crashed, ERR_RESOURCE where
// it took too long or too much.
status child_run(const child_job *job, void *answer);
void child_answer_free(const child_job *job, void *answer);
