// reach/embree_door.h
// The door to Embree: a tree of boxes that finds what is near a point. Embree reckons in single
// precision; boxes and radii are made larger inside by what that may cost, so that nothing near is
// missed, and what decides is left to the caller, in double. No Embree type passes through.
#pragma once

#include "base/status.h"

typedef struct box_tree box_tree;

// The box of item i, low <= high, finite.
typedef void item_box(const void *context, int i, double low[3], double high[3]);

// Looks at item i. Returns how far from the point items still matter, at most what the last call
// returned (from the first: the radius asked for); negative: it has seen enough.
typedef double item_visit(void *context, int i);

typedef struct embree_door {
    // n >= 1 items. No thread is started. ERR_RESOURCE for want of memory.
    status (*make)(int n, item_box *box, const void *context, box_tree **out);

    // Visits every item whose box comes within `radius` (INFINITY: all) of p, and maybe some more,
    // near ones first as far as the tree tells. Any number of threads may ask at once.
    void (*near)(const box_tree *t, const double p[3], double radius, item_visit *visit,
                 void *context);

    void (*free)(box_tree *t); // NULL is nothing
} embree_door;

// const embree_door *stiffaxis_embree_door(void)
#define EMBREE_DOOR_SYMBOL "stiffaxis_embree_door"
typedef const embree_door *(*embree_door_getter)(void);

// Opens the module once.
status embree_door_open(const embree_door **out);
