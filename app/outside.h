// app/outside.h
// Another program as a child process: found on the PATH, run without a shell in a private directory
// that is removed again, with limits on its time. Nothing of it is linked; files are exchanged.
#pragma once

#include "base/status.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

typedef struct outside_program {
    const char *file; // of the executable: "getdp"
    const char *name; // as messages call it: "GetDP"
    int seconds;      // of CPU, and of waiting
} outside_program;

enum { OUTSIDE_PATH = 4096 };

// Path of the program; false where it is not installed.
bool outside_find(const outside_program *p, char *path, size_t size);

// Makes a private directory under TMPDIR. From here to outside_leave, which every way out of the
// caller takes, an interrupt waits. `directory` [OUTSIDE_PATH] is empty where there is none.
status outside_enter(const outside_program *p, char *directory);
// Removes it; `st`, or ERR_INTERRUPTED.
status outside_leave(const char *directory, status st);

status outside_open(const outside_program *p, const char *directory, const char *name,
                    const char *mode, FILE **out);
status outside_close_written(const outside_program *p, FILE *file);

// Runs it there; arguments[0] is its name, NULL ends them (at most 15). Its words go to log.txt.
// ERR_RESOURCE: not installed, or out of time; ERR_NUMERIC: it failed; ERR_INTERRUPTED. CPU time
// [s]; may be NULL.
status outside_run(const outside_program *p, const char *directory, const char *const *arguments,
                   double *cpu_seconds);
