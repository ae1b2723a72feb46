// io/store_cut.h
// How elements of high order are cut into linear cells.
#pragma once

#include "base/element.h"

#include <stddef.h>

enum {
    CUT_MAX_CELLS = ELEMENT_MAX_ORDER * ELEMENT_MAX_ORDER * ELEMENT_MAX_ORDER,
    CUT_MAX_CORNERS = 8
};

// Linear cells on an element's lattice nodes, in VTK's order of corners; of a brick, plane node +
// nodes of the plane element x level.
typedef struct cut {
    int type, ncell, ncorner; // VTK's number of the type
    int corner[CUT_MAX_CELLS][CUT_MAX_CORNERS];
} cut;

// A plane element of an order, with `layers` the order of the brick on it along s; 0: itself, which
// may also be a line. ERR_BUG for another shape.
status cut_element(shape shape, int order, int layers, cut *out);
