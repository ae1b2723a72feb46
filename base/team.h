// base/team.h
// Independent pieces of work shared out over processes of this machine: each worker is a fork of
// this process, so that what it reads is there already and what it breaks stays its own.
#pragma once

#include "base/status.h"

#include <stddef.h>

// Does item `i`; writes `size` bytes to `result`. Runs in a worker.
typedef status team_work(void *context, int item, void *result);

typedef struct team_options {
    int workers; // 0: as many as there are cores; 1: no fork at all
    // called in the first process now and then with what is done; not OK: the work ends. May be
    // NULL
    status (*heard)(void *context, int done, int count);
    void *context; // of heard
} team_options;

// Results in the items' order, whatever worker did them [n][size]. The first item (by its number)
// that fails is what fails; ERR_BUG where a worker dies. An interrupt ends all workers.
status team_map(team_work *work, void *context, int n, size_t size, const team_options *options,
                void *results);
