// fem/doubling_cut.h
// The unknowns of a cut across a prism, sorted by the symmetries of the slab between two cuts.
// docs/theory.md (5.12)
//
// Every part of the cut's motions that its symmetries keep apart from the others is a problem of
// its own. Within a part the slab's reversal J, which exchanges its two ends, is +1 on the first
// unknowns and -1 on the rest. A rigid motion q of the whole section and what remains when three
// pins follow it are separate unknowns: u = R q + v, v = 0 on the pins' unknowns, whose places q
// takes. So stiffnesses of the section as a whole are numbers of their own size, not differences of
// the elements'.
#pragma once

#include "base/dense.h"
#include "fem/plane_symmetry.h"

// x -> sign x of the image node
typedef struct involution {
    const int *image; // [nplane]; NULL: every node its own
    double sign[3];   // along a, b, z
} involution;

enum { CUT_MOST_PARTS = 4 };

typedef struct cut_part {
    int n, neven;  // unknowns, and how many of them J keeps
    int nrigid;    // of the six rigid motions about the centre along a, b, z
    int rigid[6];  // which, 0..5
    int at[6];     // the unknown that is motion rigid[k]
    double *R;     // [nrigid][n] motions of the unknowns, pins included
    int *index;    // [3 nplane][2] unknown of a node's direction among the even and the odd, -1
    double *share; // [3 nplane][2] u of the node = sum share x unknown
    bool *axial;   // [n] along z
} cut_part;

typedef struct cut {
    int nplane;
    double centre[2]; // of the rigid motions, in the section's own axes [m]
    double angle;     // of a from the section's x
    double sign[3];   // of J
    int npart;
    cut_part part[CUT_MOST_PARTS];
} cut;

// plain: up to two involutions that exchange nodes of one level and keep the slab as it is. weight
// [nplane]: how stiff it is about a node; pins are where that is large, so that a strip much
// stiffer than all else is not far from the rigid motion. ERR_INPUT where the section has no
// extent.
status cut_make(const mesh *plane, const plane_symmetry *s, const involution *reversal, int nplain,
                const involution *plain, const double *weight, cut *out);
void cut_free(cut *c);

// Forces of the nodes [nplane][3] along a, b, z -> forces on a part's unknowns [n].
void cut_force(const cut *c, int part, const double *f, double *g);

// Adds a part's motion [n] to u [nplane][3] along a, b, z.
void cut_motion(const cut *c, int part, const double *x, double *u);
