// io/store_inside.h
// What store.c and store_read.c share.
#pragma once

#include "io/disk.h"
#include "io/store_reader.h"

#define STORE_SCHEMA "stiffaxis/result/3"

struct store {
    char path[DISK_MAX_PATH - 64]; // room for ".tmp-PID"
    char work[DISK_MAX_PATH];
    const hdf5_door *door; // writing
    hdf5_file *file;
    bool shared, first_rank;
    store_reader reader; // reading
};
