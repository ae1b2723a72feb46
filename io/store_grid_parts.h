// io/store_grid_parts.h
// What the files of store_grid.h share.
#pragma once

#include "io/store_cut.h"
#include "io/store_grid.h"

// how many points, cells and corners there are
typedef struct amount {
    size_t point, cell, index;
} amount;

// layers and levels of a piece that this rank writes
typedef struct share {
    int layer, last_layer, level, last_level;
} share;
share share_of(const store_grid_piece *p, bool first_rank);

// all pieces, one after another under /VTKHDF
typedef struct grid {
    const hdf5_door *door;
    hdf5_file *file;
    bool first_rank;
    int npiece;
    const store_grid_piece *piece;
    amount *count; // [npiece]
    amount *from;  // [npiece + 1] of all pieces before
} grid;

// NAME below VTKHDF: an array of n rows, and some of its rows.
status grid_make_room(const grid *g, const char *name, size_t n, int kind, size_t width,
                      const char *unit);
status grid_write_rows(const grid *g, const char *name, size_t first, size_t n, int kind,
                       size_t width, const void *data);

// io/store_grid_cells.c
status grid_count(grid *g);
status grid_write_topology(const grid *g);
