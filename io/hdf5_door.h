// io/hdf5_door.h
// What the HDF5 module exports: a table of functions behind `hdf5_door_table`. No HDF5 type leaves
// the module.
//
// Names are paths from the root, "section/EA_N". What is read is judged first: plain links only,
// contiguous or chunked data that lie in the file itself, no filter but deflate and shuffle, sizes
// within HDF5_MAX_BYTES.
#pragma once

#include "base/status.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef enum hdf5_kind {
    HDF5_REAL,    // double
    HDF5_INTEGER, // int
    HDF5_LONG,    // int64_t
    HDF5_BYTE,    // uint8_t
    HDF5_TEXT,    // one text of shape[0] bytes; rank 1
} hdf5_kind;

enum { HDF5_MAX_RANK = 4 };

#define HDF5_MAX_BYTES ((size_t)1 << 30) // of one array: a result is far smaller

typedef struct hdf5_array {
    int kind, rank;
    size_t shape[HDF5_MAX_RANK];
} hdf5_array;

typedef struct hdf5_file hdf5_file;

typedef struct hdf5_door {
    // A new file, in memory: HDF5 crashes at exit after a disk that was full. `path` is only looked
    // at: a file that is there already is ERR_RESOURCE.
    status (*create)(const char *path, hdf5_file **out);
    // Groups are made as needed; unit becomes the attribute `unit`.
    status (*write)(hdf5_file *f, const char *name, const hdf5_array *array, const void *data,
                    const char *unit);
    // The same in two steps: room for an array, then some of its rows, from `first` on; array: kind
    // and shape of these rows.
    status (*make)(hdf5_file *f, const char *name, const hdf5_array *array, const char *unit);
    status (*rows)(hdf5_file *f, const char *name, size_t first, const hdf5_array *array,
                   const void *data);
    // An attribute of a group, which is made as needed; "/" is the root.
    status (*put)(hdf5_file *f, const char *group, const char *name, const hdf5_array *array,
                  const void *data);
    // The new file's bytes, *image the caller's to free; f stays open.
    status (*image)(const hdf5_file *f, void **image, size_t *bytes);
    // Of several ranks, as they run under mpirun; 0 and 1 where MPI was not started.
    void (*ranks)(int *rank, int *size);
    void (*tell)(void *data, size_t size); // the first rank's bytes to all
    status (*agree)(status mine);          // the worst of all ranks
    // (all) A new file that all ranks write: every function but `rows` is called by all alike. What
    // fails on one of them is told by `finish`, which closes and frees f.
    status (*create_shared)(const char *path, hdf5_file **out);
    status (*finish)(hdf5_file *f);

    void (*close)(hdf5_file *f); // a new file, which is lost. A file that is read ends with its
                                 // process

    status (*open)(const char *path, hdf5_file **out); // ERR_FILE
    bool (*has)(const hdf5_file *f, const char *name);
    status (*look)(const hdf5_file *f, const char *name, hdf5_array *out); // ERR_FILE
    // Into data of the size that `look` told. ERR_FILE
    status (*read)(const hdf5_file *f, const char *name, const hdf5_array *array, void *data);
    // A text attribute of the root, shorter than `size`. ERR_FILE
    status (*get_text)(const hdf5_file *f, const char *name, size_t size, char *text);
} hdf5_door;

typedef const hdf5_door *(*hdf5_door_table_function)(void);
#define HDF5_DOOR_SYMBOL "hdf5_door_table"

static inline size_t hdf5_kind_size(int kind)
{
    return kind == HDF5_REAL || kind == HDF5_LONG ? 8 : kind == HDF5_INTEGER ? 4 : 1;
}

// Bytes of an array; false where they pass HDF5_MAX_BYTES.
static inline bool hdf5_array_bytes(const hdf5_array *array, size_t *bytes)
{
    *bytes = hdf5_kind_size(array->kind);
    for (int i = 0; i < array->rank; i++) {
        if (array->shape[i] != 0 && *bytes > HDF5_MAX_BYTES / array->shape[i]) {
            return false;
        }
        *bytes *= array->shape[i];
    }
    return true;
}

static inline hdf5_array hdf5_text_of(size_t length)
{
    return (hdf5_array){.kind = HDF5_TEXT, .rank = 1, .shape = {length}};
}
