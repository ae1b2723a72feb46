// section/corners.h
// Places of a mesh where the warping is not smooth: what its elements make of edges and interfaces.
#pragma once

#include "base/material.h"
#include "base/mesh.h"
#include "meshes/corner.h"

typedef struct corners {
    corner strongest; // at free edges that turn, and where interfaces end, turn or meet
    bool bends;       // a free edge or an interface goes on smoothly, but with another curvature
} corners;

// Of a plane mesh; materials: the mesh's. turning: the pattern turns along the rod.
status corners_find(const mesh *m, const material *materials, bool turning, corners *out);
