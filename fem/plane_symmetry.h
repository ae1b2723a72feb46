// fem/plane_symmetry.h
// Mirror lines and the half turn of a plane mesh, found on its nodes: what its materials say to
// that must be asked of the elements.
#pragma once

#include "base/mesh.h"

enum { MIRROR_A, MIRROR_B, HALF_TURN, PLANE_SYMMETRIES };

typedef struct plane_symmetry {
    double centre[2]; // on the mirror lines, and of the half turn [m]
    double angle;     // of axis a, along the first mirror line, from x; b is a right angle further
    int *partner[PLANE_SYMMETRIES]; // [nnode] images of the nodes: mirrored about a, about b,
                                    // turned by pi; NULL where that is no symmetry
} plane_symmetry;

// about_origin: only symmetries that keep the origin.
status plane_symmetry_find(const mesh *plane, bool about_origin, plane_symmetry *out);
void plane_symmetry_free(plane_symmetry *s);
