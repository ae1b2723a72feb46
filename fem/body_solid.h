// fem/body_solid.h
// The solid mesh of a body, for pictures and the store: base/mesh.h knows one order only, so layers
// get the plane mesh's. docs/theory.md (5.16)
#pragma once

#include "fem/body.h"

// Of the layers whose levels are all held: all of them, or one rank's. Node = plane node + (plane
// nodes) level, levels counted anew in the plane mesh's order from the first one held; elements
// layer by layer within a block, those of no matter left out. Nodes of no matter stay, unused.
status body_solid(const body *b, mesh *out);

// Values at the held levels [last - first][nplane][ncomponent] -> at the solid's nodes.
status body_solid_values(const body *b, int ncomponent, const double *held, double *solid);
