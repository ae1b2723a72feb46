// app/interrupt.h
// Ctrl-C leaves at once with exit code 130, except while something on disk has to be finished or
// removed first.
#pragma once

#include "base/status.h"

#include <stdbool.h>

// SIGINT, SIGTERM and SIGHUP end the program with exit code 130; a closed pipe, or a file
// beyond the limit on sizes, becomes a write error.
void interrupt_install(void);

// From here to interrupt_release a signal is only remembered.
void interrupt_hold(void);
bool interrupt_pending(void);

// ERR_INTERRUPTED where a signal came meanwhile.
status interrupt_release(void);
