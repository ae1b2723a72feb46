// app/doctor.h
// What `stiffaxis doctor` tries: each part on a small problem, with the libraries behind it.
#pragma once

#include "app/case.h"
#include "app/chain.h"
#include "app/versions.h"

enum { DOCTOR_PATH = 4096, DOCTOR_LIBRARIES = 3 };

// What the steps share: a private directory, a small case and what came out of it so far.
typedef struct patient {
    const command *cmd;
    char directory[DOCTOR_PATH];
    char told[80]; // what the last step says of itself
    case_data c;
    run_result r;
} patient;

typedef struct doctor_step {
    const char *what;
    status (*try_it)(patient *p);
    bool needed;     // else only some commands or checks are left out
    const char *get; // Debian's packages that bring what is missing
    int nlibrary;
    int library[DOCTOR_LIBRARIES];
} doctor_step;

// In the order in which they are tried; ended by one without a name.
extern const doctor_step doctor_steps[];
