// api/handles.h
// What the opaque pointers hold, and who lives how long: each is kept by its maker and by what was
// made from it.
#pragma once

#include "api/stiffaxis.h"
#include "app/variation.h"

#include <stdatomic.h>

struct stiffaxis_case {
    atomic_int users;
    case_data data;
};

struct stiffaxis_section {
    atomic_int users;
    stiffaxis_case *c;
    variation v; // its section is this one
};

struct stiffaxis_rod {
    atomic_int users;
    stiffaxis_section *section;
    varied w;
    pose base;
};

struct stiffaxis_state {
    stiffaxis_rod *rod;
    rod_state *state;
    bool answered; // there is a last answer
};

// What has state of its own (expressions, modules, gmsh) is one thread's at a time, in the locale
// "C".
void turn_begin(void);
void turn_end(void);
