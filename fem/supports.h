// fem/supports.h
// What holds and what loads a column: which nodes are unknown, which are held, and which follow the
// rigid cap.
//
// Unknowns are blocks of three. A clamped level has none. With a rigid tip the tip level has two
// blocks only: the cap's translation at the origin, and its rotation times the section's radius, so
// that all unknowns are lengths.
#pragma once

#include "fem/column.h"

typedef struct supports {
    bool clamped, cap;
    int nplane, nlevel;
    int nblock;    // of unknowns
    int cap_block; // first of two; -1 without a cap
    double radius; // scale of the cap's rotation [m]
    // base free to contract: bit d of held[i] is set where direction d of plane node i is held at
    // level 0; NULL when clamped
    unsigned char *held;
} supports;

// Base free to contract: u_z on the whole base, and u_x, u_y, u_x or u_y of two far nodes against
// rigid motion.
status supports_make(const column *c, bool clamped, bool cap, supports *out);
void supports_free(supports *s);

// -1 for nodes of a clamped level and of a rigid tip
static inline int supports_block(const supports *s, int plane_node, int level)
{
    if ((s->clamped && level == 0) || (s->cap && level == s->nlevel - 1)) {
        return -1;
    }
    return plane_node + s->nplane * (level - (s->clamped ? 1 : 0));
}

static inline bool supports_is_held(const supports *s, int plane_node, int level, int direction)
{
    return s->held && level == 0 && (s->held[plane_node] >> direction & 1);
}

// The rows of one rank of several: whole levels, and the cap with the last.
typedef struct supports_share {
    int first_level, last_level; // first_level <= level < last_level
    int first, last;             // first <= block row < last
} supports_share;

supports_share supports_share_of(const supports *s, int rank, int size);

// Blocks of the upper triangle in the share's rows, [last - first] each: in the share's own
// columns, and beyond them.
status supports_pattern(const supports *s, const column *c, supports_share share, int *own,
                        int *beyond);

// Unknowns [nblock][3] -> displacement of all nodes [nlevel][nplane][3].
void supports_expand(const supports *s, const mesh *plane, const double *x, double *u);
