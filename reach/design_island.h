// reach/design_island.h
// One search of several.
#pragma once

#include "reach/design_log.h"
#include "reach/nlopt_door.h"

#include <stdatomic.h>
#include <stdint.h>

// What all processes of this machine see of the searches under way.
typedef struct design_pulse {
    atomic_int done, failed;
    _Atomic uint64_t goal, score; // of the best, as bits: larger ones are larger scores. Two
                                  // words, for a person to read
} design_pulse;

typedef struct design_islands {
    const design_problem *p;
    const nlopt_door *door;
    const design_log *log;
    design_pulse *pulse;
} design_islands;

// trial [p->evaluations], zeroed
status design_island(const design_islands *all, int island, design_trial *trial);

void design_pulse_begin(design_pulse *pulse);
void design_pulse_read(design_pulse *pulse, design_news *out);
