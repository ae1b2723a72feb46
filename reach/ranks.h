// reach/ranks.h
// Work shared out over the processes of an mpirun, on one machine or on many: each does its part
// alone, then all exchange what they found. MPI is started by that exchange only.
#pragma once

#include "base/status.h"

#include <stddef.h>

typedef struct ranks {
    int rank, size; // 0 and 1 without mpirun
    int local;      // processes of it on this machine
} ranks;

ranks ranks_here(void); // from the environment alone

// (all) data[i], i = 0 ... count - 1, of `bytes` each, from the rank i % size to all. Nothing is
// done where size is 1.
status ranks_share(const ranks *r, void *data, int count, size_t bytes);

// --- the door to MPI

typedef struct mpi_door {
    // Starts MPI when nobody has yet; it ends with the process.
    status (*start)(void);
    // (all) Waits without keeping the core busy.
    status (*broadcast)(int root, void *data, size_t bytes);
} mpi_door;

// const mpi_door *stiffaxis_mpi_door(void)
#define MPI_DOOR_SYMBOL "stiffaxis_mpi_door"
typedef const mpi_door *(*mpi_door_getter)(void);
