// meshes/grid_ladders.h
// Element edges in both directions of a grid.
#pragma once

#include "meshes/grid.h"
#include "meshes/ladder.h"
#include "meshes/mesher.h"

// By the target size, angles also by the arc. Smaller towards free edges and interfaces where the
// options ask for edge layers; else, without a size asked for, towards corners. l[0], l[1] are the
// caller's to free.
status grid_ladders_make(const section_outline *o, const grid *g, const mesh_options *options,
                         ladder l[2]);
