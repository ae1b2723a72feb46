// base/status.h
// How a function says that it failed: one code, which is also the program's exit code, and one
// message.
#pragma once

#include <stdbool.h>

typedef enum status {
    OK = 0,
    ERR_TOLERANCE = 1,     // done, but a comparison is out of tolerance
    ERR_INPUT = 2,         // usage or case file
    ERR_FILE = 3,          // an input file is damaged or of an unsupported kind
    ERR_NUMERIC = 4,       // no convergence, or a check of the mathematics failed
    ERR_RESOURCE = 5,      // out of memory, disk or time
    ERR_BUG = 6,           // our own mistake, or a library that broke its promise
    ERR_INTERRUPTED = 130, // the user pressed Ctrl-C
} status;

// Keeps the message (the first one since status_clear stands) and returns `code`.
status status_fail(status code, const char *format, ...) __attribute__((format(printf, 2, 3)));

// The same with a place in the case file, from 1, where the failing function knows it better than
// its caller.
status status_fail_at(status code, int line, int column, const char *format, ...)
    __attribute__((format(printf, 4, 5)));

// Whether the kept message came with a place; *line and *column are filled then.
bool status_place(int *line, int *column);

// The kept message, "" when nothing failed; valid until status_clear.
const char *status_message(void);
void status_clear(void);

// Needs `status st = OK;` and a label `done:` in the function.
#define TRY(call)                                                                                  \
    do {                                                                                           \
        st = (call);                                                                               \
        if (st != OK) {                                                                            \
            goto done;                                                                             \
        }                                                                                          \
    } while (0)
