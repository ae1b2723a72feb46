// fem/unknowns.h
// What of a body is unknown, how that is numbered, and which rank has it.
//
// Unknowns are blocks of three, level after level from the base: the nodes with matter of each
// level in the plane mesh's order. A clamped base has none. With a rigid cap the tip's level has
// two blocks, the last of all: the cap's translation at the tip's origin, and its rotation times
// the section's radius, so that all unknowns are lengths. docs/theory.md (5.7)
#pragma once

#include "fem/load.h"
#include "fem/petsc_door.h"

// What one rank has: whole layers. Its rows are those of the levels from its first layer's lower
// end to just below its last layer's upper end, which is the next rank's; the last rank with layers
// has the tip too. Ranks beyond the number of layers have nothing, and come last.
typedef struct level_share {
    int rank, size;
    int first_layer, last_layer; // first <= layer < last
    int first, last;             // levels whose rows it has: first <= level < last
    int from, to; // levels that it must hold: of its layers and of the layer below, whose elements
                  // add to its rows; from <= level < to, one level where it has no layer
} level_share;

// Layers shared out by their matter. From the spec alone: its hold_first and hold_last may come
// next.
level_share level_share_of(const body_spec *spec, int rank, int size);

typedef struct unknowns {
    const body *body;
    level_share share;
    bool cap;
    int nplane, nlevel;
    int nblock;           // of all ranks
    int first, last;      // this rank's rows: first <= block < last
    int cap_block;        // first of two, -1 without a cap
    double radius;        // scale of the cap's rotation [m]
    double cap_origin[3]; // where the tip's level is held [m]
    int *start;           // [nlevel + 1] first block of each level, without the cap's
    // of the levels held, [to - from][nplane]:
    int *number;         // of a node among the blocks of its level, -1: none; NULL: its own number
    unsigned char *held; // bit d: direction d of the node is held; NULL: nothing is
    double *motion;      // [3] by which held directions move [m]; NULL: none does
} unknowns;

// ERR_INPUT where holds contradict base or tip, ERR_RESOURCE where there are too many unknowns.
status unknowns_make(const segment_problem *p, level_share share, unknowns *out);
void unknowns_free(unknowns *u);

// Fills held and motion; unknowns_make calls it.
status unknowns_hold(const segment_problem *p, unknowns *u);

// Index of a node of a level that is held into the arrays above.
static inline size_t unknowns_index(const unknowns *u, int plane_node, int level)
{
    return (size_t)(level - u->share.from) * (size_t)u->nplane + (size_t)plane_node;
}

// -1 for nodes that are clamped, follow the cap, or are no part of any matter
static inline int unknowns_block(const unknowns *u, int plane_node, int level)
{
    if (u->start[level + 1] == u->start[level]) {
        return -1;
    }
    const int n = u->number ? u->number[unknowns_index(u, plane_node, level)] : plane_node;
    return n < 0 ? -1 : u->start[level] + n;
}

static inline bool unknowns_is_held(const unknowns *u, int plane_node, int level, int direction)
{
    return u->held && (u->held[unknowns_index(u, plane_node, level)] >> direction & 1);
}

static inline bool unknowns_follow_cap(const unknowns *u, int level)
{
    return u->cap && level == u->nlevel - 1;
}

static inline bool unknowns_has_tip(const unknowns *u) // whether its rows are this rank's
{
    return u->share.first < u->share.last && u->share.last == u->nlevel;
}

// Motion of a node of the tip by the cap's six unknowns, rows by direction. (5.7)
void unknowns_cap_motion(const unknowns *u, int plane_node, double T[3][6]);

// Upper bounds of the blocks of the upper triangle in this rank's rows [last - first]: in its own
// columns, and beyond them; exact where all is matter.
status unknowns_pattern(const unknowns *u, int *own, int *beyond);

// Displacements [nplane][3] of a level that is held from its blocks, [start[level + 1] -
// start[level]][3], and the cap's [2][3] (at the tip only, else NULL). Held directions move by
// `motion` where `moves`, else not at all.
void unknowns_expand(const unknowns *u, int level, const double *blocks, const double *cap,
                     bool moves, double *displacement);

// Adds a nodal force to this rank's right-hand side [last - first][3]: not to other ranks' rows,
// nor to directions that are held; the cap gathers its nodes' forces.
void unknowns_add_force(const unknowns *u, int plane_node, int level, const double *force,
                        double *b);

// The same of all nodes: force [to - from][nplane][3] of the levels held, b [last - first][3] anew.
void unknowns_gather(const unknowns *u, const double *force, double *b);

// (all) ERR_NUMERIC, with the motion, where springs and holds leave the body free to move as a
// whole.
status unknowns_check_supports(const petsc_door *door, const segment_problem *p, const unknowns *u);

// The body's rigid motions, rotations over the radius, at this rank's rows [6][last - first][3];
// zero where directions are held.
void unknowns_rigid(const unknowns *u, double *motions);
