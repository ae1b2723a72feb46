// section/corners.h
// Places of a mesh where the warping is not smooth: what its elements make of edges and interfaces.
#pragma once

#include "base/material.h"
#include "base/mesh.h"
#include "meshes/corner.h"

// The strongest corner of a plane mesh: at free edges that turn, and where interfaces end, turn or
// meet. materials: the mesh's.
status corners_strongest(const mesh *m, const material *materials, corner *out);
