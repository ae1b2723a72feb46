// io/store_reader.h
// HDF5's library is known to crash on damaged files. So a child process with limits reads the file,
// and hands over arrays one by one: whatever happens to it is an ERR_FILE here.
#pragma once

#include "io/hdf5_door.h"

#include <sys/types.h>

enum {
    READER_SECONDS = 60,      // of the child's processor time, and of waiting for one answer
    READER_MAX_NAME = 200,    // of an array, with the NUL
    READER_MAX_MESSAGE = 300, // of the child's words on a failure
};

typedef struct store_reader {
    pid_t child;
    int channel; // a socket to the child
} store_reader;

// The file is there, is a regular file and begins as HDF5 does: else ERR_INPUT (not there) or
// ERR_FILE.
status store_sniff(const char *path);

// Starts the child, which opens the file and checks that its attribute `schema` is the one given.
status store_reader_start(const char *path, const char *schema, store_reader *out);
void store_reader_stop(store_reader *r);

bool store_reader_has(const store_reader *r, const char *name);

// Kind and shape, and the data too where data is not NULL: the caller's to free, one zero byte
// after the last item.
status store_reader_get(const store_reader *r, const char *name, hdf5_array *array, void **data);
