// base/team.h
// Independent pieces of work shared out over processes of this machine: each worker is a fork of
// this process, so that what it reads is there already and what it breaks stays its own.
#pragma once

#include "base/status.h"

#include <stddef.h>

// Does item `i`; writes `size` bytes to `result`, zeroed before. Runs in a worker, which leaves
// without the exit handlers and buffers of this process: it prints nothing.
typedef status team_work(void *context, int item, void *result);

typedef struct team_options {
    int workers; // 0: as many as this process has cores; 1: no fork at all
    // called in the first process whenever an item is done, and several times a second; not OK: all
    // workers end. May be NULL
    status (*heard)(void *context, int done, int count);
    void *context; // of heard
} team_options;

// Results in the items' order, whatever worker did them [n][size]. Items are begun in their order;
// the first one by number that fails is what fails, with its message, and no more are begun.
// ERR_BUG where a worker dies, ERR_RESOURCE where it was killed. Whatever ends this process ends
// the workers; none is left behind. options may be NULL.
status team_map(team_work *work, void *context, int n, size_t size, const team_options *options,
                void *results);

// Cores that this process may run on, at least 1.
int team_cores(void);
