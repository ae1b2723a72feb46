// fem/way_fill.h
// What a way_run says, from displacements that ranks have by levels: motions, resultants, the
// window's energy. docs/theory.md (5.2), (5.5), (5.13)
#pragma once

#include "fem/level_loads.h"
#include "fem/way.h"

// A solution, on the levels of a rank's own layers: those that it has and the one above, which the
// next rank has. Nothing where it has no layer.
typedef struct way_field {
    const petsc_door *door;
    const segment_problem *p;
    level_share share;
    const level_loads *loads;
    int nheld;       // layers' levels: (last_layer - first_layer) order + 1
    const double *u; // [ncolumn][nheld][nplane][3] [m]
} way_field;

static inline int way_field_levels(const level_share *s, int order)
{
    return s->last_layer > s->first_layer ? (s->last_layer - s->first_layer) * order + 1 : 0;
}

static inline const double *way_field_level(const way_field *f, int column, int level)
{
    const size_t n = 3 * (size_t)f->p->body->plane->nnode;
    return f->u + ((size_t)column * (size_t)f->nheld + (size_t)(level - f->share.first)) * n;
}

// Displacements of the level above this rank's own, from the next rank: u as above, own levels
// filled. (all)
void way_field_get_above(const petsc_door *door, const body *b, const level_share *s, int ncolumn,
                         double *u);

// (all) Takes the base's E-weighted mean motion in its plane out of all levels of u, the field's
// own: of a base free to contract only strains are sure. (5.8)
status way_field_centre(const way_field *f, double *u);

// (all) Fills ncolumn, nlevel, z, motion, resultant, energy, and where wanted first, last, u.
status way_fill(const way_field *f, const way_wants *wants, way_run *out);

// --- parts of way_fill

// Into resultant [ncolumn][nlevel]: of this rank's levels, zero elsewhere. fem/way_resultant.c
status way_resultants(const way_field *f, vec6 *resultant);

// (all) fem/way_energy.c
status way_window_energy(const way_field *f, const way_wants *wants, const vec6 *motion,
                         mat6 *energy);

// Nodal values of a column in an element [per_elem (order + 1)][3].
void way_field_gather(const way_field *f, int column, const int *conn, int per_elem, int layer,
                      double *u);
