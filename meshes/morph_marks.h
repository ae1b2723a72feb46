// meshes/morph_marks.h
// Which nodes of a plane mesh lie on borders and interfaces, and on which curves of the shapes.
#pragma once

#include "base/mesh.h"
#include "meshes/morph_curves.h"

// A node on one curve, or where two meet.
typedef struct node_mark {
    int node;
    int curve[2];    // the one on top first; -1: none
    double place[2]; // on each
} node_mark;

// mark: [*nmark] the caller's to free. ERR_NUMERIC where an edge lies on no curve.
status node_marks_make(const mesh *m, const shape_curves *c, double size, node_mark **mark,
                       int *nmark);
