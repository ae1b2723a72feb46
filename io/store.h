// io/store.h
// One HDF5 file per run: our numbers with units beside them, and VTKHDF 1.0 unstructured grids.
// Opens the HDF5 module. Built in memory, written under a temporary name, fsynced and renamed; read
// back for `report`.
#pragma once

#include "base/mesh.h"
#include "base/status.h"

#include <stdbool.h>
#include <stddef.h>

typedef struct store store;

status store_create(const char *path, store **out); // nothing on disk until store_commit
// (all) The same by all ranks of an mpirun together, where MPI was started: the first one's path
// counts, and everything below is called by all alike. No path there: *out is NULL.
status store_create_shared(const char *path, store **out);
status store_commit(store *s); // everything or nothing: path.tmp-PID, renamed; frees s
void store_abandon(store *s);  // NULL is fine

// name: "section/EA_N", groups made as needed. rank <= 4. unit: "N", "m", "-" ..., kept as
// attribute `unit`.
status store_real(store *s, const char *name, int rank, const size_t *shape, const double *data,
                  const char *unit);
// Of an array that ranks share: room for all of it, then what this one has, rows from `first` on.
status store_make(store *s, const char *name, int rank, const size_t *shape, const char *unit);
status store_rows(store *s, const char *name, size_t first, int rank, const size_t *shape,
                  const double *data);
status store_integer(store *s, const char *name, int rank, const size_t *shape, const int *data);
status store_text(store *s, const char *name, const char *text, size_t length);

// One piece of the unstructured grid at /VTKHDF. A high-order cell is cut into order^dim linear
// cells on its nodes. All pieces must have the same point fields; cell data: material, part (the
// piece's number).
typedef struct store_field {
    const char *name;   // with its unit, "displacement_GC_m"
    int ncomponent;     // 1, 3, or 6 for a symmetric tensor, as VTK has it: xx yy zz xy yz xz
    const double *data; // [nnode][ncomponent] of the nodes here; NULL: not a number, everywhere
} store_field;

// A solid: the elements of a plane mesh, layer upon layer. A rank of several has some of its
// levels.
typedef struct store_layers {
    int order, nlayer; // nlayer order + 1 levels
    const int *matter; // [nlayer][elements of the plane mesh] material, -1: nothing there; NULL:
                       // the plane mesh's own in every layer
    int first, last;   // levels here: first <= level < last
    const double *xyz; // [last - first][nnode of the plane mesh][3] [m]
} store_layers;

typedef struct store_grid_piece {
    const mesh *mesh;
    const store_layers *layers; // NULL: the mesh alone, whole on the first rank
    const double *displacement; // [nodes here][3] added to the coordinates; NULL: undeformed
    int nfield;
    const store_field *field;
} store_grid_piece;
status store_grid(store *s, int npiece, const store_grid_piece *pieces);

status store_open(const char *path,
                  store **out); // ERR_FILE: damaged, or not a result of this program
bool store_has(const store *s, const char *name);
// *data is the caller's to free; shape[4] filled, rank in *rank.
status store_read_real(const store *s, const char *name, int *rank, size_t shape[4], double **data);
status store_read_integer(const store *s, const char *name, int *rank, size_t shape[4], int **data);
status store_read_text(const store *s, const char *name, char **text,
                       size_t *length); // NUL added after length
void store_close(store *s);
