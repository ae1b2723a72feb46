// rodsolver/equilibrium_derive.h
// What derivatives by loads and by designs share.
#pragma once

#include "rodsolver/equilibrium.h"

typedef struct place {
    int pair;
    double s;   // [m]
    double t;   // in panel lengths, 0 to 2
    mat3 R;     // of the section there, base frame
    mat6 to_gc; // strains and twists of the solve's frame -> the geometric centre's
} place;

place derive_find_place(const equilibrium *e, const rod_state *state, double s);

// Answers e->rv, e->rw with lengths changing by e->tension_step; e->lost where friction hides it.
void derive_answer(equilibrium *e);
status derive_check(const equilibrium *e);

// The body twist of the geometric centre's pose by the answer in e->phi, e->omega, e->nu.
vec6 derive_twist_at(const equilibrium *e, const place *at);
