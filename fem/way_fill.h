// fem/way_fill.h
// What a way_run says, from displacements that ranks have by levels: motions, resultants, what they
// must balance, the window's energy. docs/theory.md (5.2), (5.5), (5.13)
#pragma once

#include "fem/level_loads.h"
#include "fem/way.h"

// A solution on the levels that a rank holds: its own, the layer's below, and the one above.
typedef struct way_field {
    const petsc_door *door;
    const segment_problem *p;
    level_share share;
    const unknowns *unknowns;
    const level_loads *loads;
    double *u; // [ncolumn][to - from][nplane][3] [m]
} way_field;

static inline size_t way_field_offset(const way_field *f, int column, int level)
{
    const size_t held = (size_t)(f->share.to - f->share.from);
    return ((size_t)column * held + (size_t)(level - f->share.from)) * 3 *
           (size_t)f->p->body->plane->nnode;
}

static inline double *way_field_level(const way_field *f, int column, int level)
{
    return f->u + way_field_offset(f, column, level);
}

// (all) Levels that other ranks own, from those.
void way_field_exchange(const way_field *f);

// (all) Takes the base's E-weighted mean motion in its plane out of all levels: of a base free to
// contract only strains are sure. (5.8)
status way_field_centre(const way_field *f);

typedef struct level_forces level_forces;

// (all) Fills ncolumn, nlevel, z, motion, resultant, applied, energy, and where wanted first, last,
// own_first, own_last, u. `inner`: what the field's elements put on nodes (fem/level_forces.h).
status way_fill(const way_field *f, const level_forces *inner, const way_wants *wants,
                way_run *out);

// --- parts of way_fill

// Into resultant [ncolumn][nlevel]: of this rank's levels, zero elsewhere. fem/way_resultant.c
void way_resultants(const way_field *f, const level_forces *inner, vec6 *resultant);

// (all) The same of what acts beyond a level, on all ranks.
status way_applied(const way_field *f, const level_forces *inner, vec6 *applied);

// (all) fem/way_energy.c
status way_window_energy(const way_field *f, const way_wants *wants, const vec6 *motion,
                         mat6 *energy);
