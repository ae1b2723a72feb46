// io/store_grid.h
// /VTKHDF version 1.0: an unstructured grid of linear cells, one partition per piece, as VTK 9.1
// and ParaView 5.11 read it.
#pragma once

#include "io/hdf5_door.h"
#include "io/store.h"

// ERR_BUG where the pieces' fields differ or an element is neither plane nor solid.
//
// Of several ranks each writes its own levels, the first one what has none; all call it.
status store_grid_write(const hdf5_door *door, hdf5_file *file, bool first_rank, int npiece,
                        const store_grid_piece *pieces);
