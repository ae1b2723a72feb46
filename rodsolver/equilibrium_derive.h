// rodsolver/equilibrium_derive.h
// What derivatives by loads and by designs share.
#pragma once

#include "rodsolver/equilibrium.h"

typedef struct inside_point {
    mat3 R;                       // of the section there, base frame
    vec3 arm;                     // from there to the place, base frame
    double weight[PAIR_STATIONS]; // of the pair's stations there
} inside_point;

typedef struct place {
    int pair, node;                     // node: the last one up to the place
    double s;                           // [m]
    double t;                           // in panel lengths, 0 to 2
    double inside;                      // from the node to the place [m]
    vec3 arm;                           // the same as a vector, base frame
    inside_point point[GAUSS_STATIONS]; // in between; unset where nothing is
    mat3 R;                             // of the section there, base frame
    mat6 to_gc; // strains and twists of the solve's frame -> the geometric centre's
} place;

// The state's last answer linearised as equilibrium_resume does, on a plan fine enough for what its
// derivatives are asked for.
status derive_resume(rod_state *state);

place derive_find_place(const equilibrium *e, const rod_state *state, double s);

// Answers e->rv, e->rw with lengths changing by e->tension_step; e->lost where friction hides it.
void derive_answer(equilibrium *e);
status derive_check(const equilibrium *e);

// The body twist of the geometric centre's pose by the answer in e->phi, e->omega, e->nu, e->step.
vec6 derive_twist_at(const equilibrium *e, const place *at);
