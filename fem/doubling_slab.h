// fem/doubling_slab.h
// One slab of a prism: its elements, the symmetries that they have, and its stiffness condensed to
// its two ends. docs/theory.md (5.12)
#pragma once

#include "fem/body.h"
#include "fem/doubling_cut.h"

// Stiffness between the two ends of a slab, of one part of the cut: with u at the lower end and J w
// at the upper
//
//   energy = (u + w)^T P (u + w) / 4 + (u - w)^T N (u - w) / 4
//
// Lower triangles, by columns [n][n].
typedef struct slab_stiffness {
    double *P, *N;
} slab_stiffness;

typedef struct slab {
    const mesh *plane;
    int order, nelem;
    double height, turn; // [m]; angle by which the upper end is turned [rad]
    double **K;          // [nelem] of the elements [3n][3n], along a, b, z of each level's section
} slab;

// The elements of a body of one layer from s = 0 on as brick.h has them, directions turned by
// angle.
status slab_make(const body *thin, double angle, slab *out);
void slab_free(slab *s);

static inline int slab_level_dofs(const slab *s)
{
    return 3 * s->plane->nnode;
}

// Whether the elements agree that x -> sign x of the image (and of the opposite level where
// `reversed`) changes nothing: asked on one motion without symmetry.
status slab_has(const slab *s, const involution *g, bool reversed, bool *out);

// Condenses the levels between the ends. The caller frees P and N.
status slab_condense(const slab *s, const cut *c, int part, slab_stiffness *out);

// Makes stiffnesses of a part do no work on rigid motions of the whole slab, exactly: what is left
// of them is rounding.
status slab_forget_rigid(const cut *c, int part, double height, double turn, slab_stiffness *k);
