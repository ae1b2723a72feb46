// fem/way.h
// Three ways to solve a segment_problem, one answer: docs/theory.md (5.12) to (5.15)
//
//   doubling   one slab condensed, joined with itself again and again: prisms, turning ones too.
//              Slabs are length / 2^k thick, no thicker than the body's thinnest layer, and of its
//              order (2 costs least), whatever the other layers are
//   direct     sparse factors of the whole (MUMPS)
//   iterative  conjugate gradients, matrix-free, multigrid over the orders; on many ranks
#pragma once

#include "base/beam_law.h"
#include "fem/load.h"

typedef enum segment_way { WAY_AUTO, WAY_DOUBLING, WAY_DIRECT, WAY_ITERATIVE } segment_way;

// What the caller wants beyond motions, resultants and the middle's energy.
typedef struct way_wants {
    bool fields;             // displacements at the body's levels
    double middle;           // height of the window's centre [m]
    double middle_half;      // half its height [m]
    bool (*cancelled)(void); // NULL: never
} way_wants;

// One solved problem. Motions and wrenches about the section's origin at that height, in the base's
// axes; on every rank.
typedef struct way_run {
    int ncolumn;
    int nlevel;   // heights at which sections were fitted: the body's levels, or a doubling's cuts
    double *z;    // [nlevel] s [m], ascending; the first is the base, the last the tip
    vec6 *motion; // [ncolumn][nlevel] E-weighted fits (5.2) [m, rad per N or N m]
    vec6 *resultant; // [ncolumn][nlevel] of the stresses that the part beyond puts on the section
    vec6 *applied; // [ncolumn][nlevel] of all that acts on the part beyond: loads, springs, holds;
                   // the section's stresses must balance it. NULL: nothing but what acts on the tip
    mat6 energy;   // (5.5) int eps_i^T Q eps_j over the window for unit wrenches at its centre, in
                   // the base's axes
    double *work;  // [ncolumn][ncolumn] f_i . u_j: twice the energies [J]
    long long dofs;
    double residual;                                        // largest |f - K u| / (|K| |u| + |f|)
    int iterations;                                         // 0: none
    double assemble_seconds, factor_seconds, solve_seconds; // CPU time of this rank
    double bytes; // largest memory of this rank that the way took, where known
    // where fields were asked for: levels of the body that this rank has, those of the layer below
    // its own among them, so that it knows all elements about its own levels
    int first, last;
    bool shared; // ranks have different levels: all of them must take part in writing fields
    int own_first, own_last; // of those what is this rank's to tell: every level is one rank's;
                             // both 0: all of them
    double *u;               // [ncolumn][last - first][nplane][3] [m]
} way_run;
void way_run_free(way_run *run);

static inline const double *way_run_level(const way_run *run, int nplane, int column, int level)
{
    const size_t n = 3 * (size_t)nplane, held = (size_t)(run->last - run->first);
    return run->u + ((size_t)column * held + (size_t)(level - run->first)) * n;
}

// ERR_INPUT: the way does not take such a problem. ERR_RESOURCE: no memory; ERR_NUMERIC: singular
// supports, or no convergence.
status way_doubling(const segment_problem *p, const way_wants *wants, way_run *out);
status way_direct(const segment_problem *p, const way_wants *wants, way_run *out);
status way_iterative(const segment_problem *p, const way_wants *wants, way_run *out);

// What a way will take, from counts alone: the cost model. Measured by `./run bench segment`.
typedef struct way_cost {
    bool possible;
    double seconds, bytes;
} way_cost;
way_cost way_cost_doubling(const segment_problem *p, int nrank);
way_cost way_cost_direct(const segment_problem *p, int nrank);
way_cost way_cost_iterative(const segment_problem *p, int nrank);
