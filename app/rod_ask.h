// app/rod_ask.h
// The solutions that a case asks for, as requests to its rod.
#pragma once

#include "rodsolver/rod_case.h"

typedef struct rod_ask {
    const rod_case *rod;
    int count; // solutions
    pose base;
    double *tension, *pull, *load; // [ntendon], [ntendon], [nload] of the request at hand
    rod_request request;           // points to the four above
} rod_ask;

status rod_ask_make(const rod_case *rod, rod_ask *out); // in place: *out must not move
void rod_ask_free(rod_ask *ask);

// Fills ask->request for solution i.
void rod_ask_fill(rod_ask *ask, int i);

// Whether a solve that failed ended at a limit point, whose shape the state then has.
bool rod_ask_limited(status st, const rod_solution *solution);
