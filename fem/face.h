// fem/face.h
// Faces of a body: what loads, springs and holds act on. docs/theory.md (5.11)
#pragma once

#include "fem/load.h"

// One side of an element of the plane mesh with nothing beyond it; it runs with the matter on its
// left.
typedef struct border_side {
    int block, e;
    int side; // quad: from (-1, -1) on, counter-clockwise; triangle: from (0, 0)
    int loop;
} border_side;

// The border of a layer's matter: closed loops, which are the sections of the walls.
typedef struct face_border {
    int nside, nloop;
    border_side *side;
    int *face;    // [nloop] FACE_OUTSIDE, or FACE_HOLE + k, k = 0 the largest hole
    double *area; // [nloop] within the loop [m^2]; negative where the matter is around it
} face_border;

// Of a layer; without spec.matter they are all the same.
status face_border_make(const body *b, int layer, face_border *out);
void face_border_free(face_border *f);

// Nodes of a side in its direction, plane->order + 1 of them.
int border_side_nodes(const body *b, const border_side *s, int node[ELEMENT_MAX_ORDER + 1]);

// ERR_INPUT where the body has no such face: the hole does not exist, or in no layer of the part.
status face_check(const body *b, const face_part *part);

enum { FACE_MAX_NODES = ELEMENT_MAX_PLANE_NODES, FACE_MAX_POINTS = 49 };

// What one element of a face is: of a wall a side over the height of a layer, cut where the part
// begins or ends; of an end a plane element.
typedef struct face_patch {
    int layer; // of the element that it bounds
    int nnode;
    int plane_node[FACE_MAX_NODES], level[FACE_MAX_NODES];
    int npoint;
    double N[FACE_MAX_POINTS][FACE_MAX_NODES];
    double normal[FACE_MAX_POINTS][3]; // out of the matter, in the base's axes
    double dA[FACE_MAX_POINTS];        // weight of a point [m^2]
} face_patch;

// Visits every patch that bounds an element of the layers from first to last - 1, whose levels are
// held.
typedef status (*face_visit)(void *self, const face_patch *patch);
status face_walk(const body *b, const face_part *part, int first, int last, face_visit visit,
                 void *self);

// Nodes of a face part at the levels from first to last - 1; those of a wall from its arclength
// `from` to its `to`. mark [last - first][nplane] becomes true where there is one.
status face_nodes(const body *b, const face_part *part, int first, int last, bool *mark);

// Adds int N^T (traction - pressure normal) dA to f [b->last - b->first][nplane][3], of patches as
// in face_walk.
status face_add_load(const body *b, const face_pressure *load, int first, int last, double *f);

// int N^T k N dA of a patch, K [3 nnode][3 nnode] by rows: normal and tangential stiffness, or
// along the base's axes.
void face_spring_matrix(const face_patch *patch, const face_spring *spring, double *K);
