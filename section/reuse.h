// section/reuse.h
// Sections already solved along a rod: the same outlines, turned or not, are solved once.
#pragma once

#include "section/section.h"

typedef struct solved_section {
    section_outline outline;
    beam_law turned; // in the frame that is turned by outline.turn
} solved_section;

typedef struct section_store {
    const section_case *request;
    const material *materials;
    int count, capacity;
    solved_section *solved;
    bool meshed;
} section_store;

// The law at s in the frame turned by *turn, solved or found.
status section_store_law(section_store *store, double s, beam_law *turned, double *turn,
                         bool *has_symmetry);
void section_store_free(section_store *store);
