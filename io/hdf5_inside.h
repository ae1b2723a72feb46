// io/hdf5_inside.h
// What the files of the HDF5 module share.
#pragma once

#include "io/hdf5_door.h"

#include <hdf5.h>

struct hdf5_file {
    hid_t id;
    hsize_t bytes;   // of the file, when reading
    bool shared;     // written by all ranks
    bool first_rank; // writes what every rank has
    status failed;   // of a shared file: what went wrong, until all know of it
    char reason[300];
};

// Identifiers to be closed together, and the reason of the first call that failed. A call that is
// given an invalid identifier fails too, so that one check at the end serves a whole function.
typedef struct hdf5_scope {
    hid_t id[12];
    int n;
    bool failed;
    char reason[160];
} hdf5_scope;

void hdf5_check(hdf5_scope *s, herr_t code);
hid_t hdf5_keep(hdf5_scope *s, hid_t id);
status hdf5_leave(hdf5_scope *s, status code, const char *what, const char *name);

// on disk as in memory; the file says which byte order that is
hid_t hdf5_array_type(hdf5_scope *s, const hdf5_array *array, H5T_cset_t characters);
hid_t hdf5_array_space(hdf5_scope *s, const hdf5_array *array);

// The parts of the table: hdf5_write_door_module.c, hdf5_read_door_module.c,
// hdf5_share_door_module.c
status hdf5_write(hdf5_file *f, const char *name, const hdf5_array *array, const void *data,
                  const char *unit);
status hdf5_make(hdf5_file *f, const char *name, const hdf5_array *array, const char *unit);
status hdf5_rows(hdf5_file *f, const char *name, size_t first, const hdf5_array *array,
                 const void *data);
status hdf5_put(hdf5_file *f, const char *group, const char *name, const hdf5_array *array,
                const void *data);
bool hdf5_has(const hdf5_file *f, const char *name);
status hdf5_look(const hdf5_file *f, const char *name, hdf5_array *out);
status hdf5_read(const hdf5_file *f, const char *name, const hdf5_array *array, void *data);
status hdf5_get_text(const hdf5_file *f, const char *name, size_t size, char *text);
void hdf5_ranks(int *rank, int *size);
void hdf5_tell(void *data, size_t size);
status hdf5_agree(status mine);
status hdf5_create_shared(const char *path, hdf5_file **out);
status hdf5_finish(hdf5_file *f);
