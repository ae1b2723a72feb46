// io/store.c
#include "io/store.h"

#include "base/door.h"
#include "base/memory.h"
#include "io/disk.h"
#include "io/store_grid.h"
#include "io/store_inside.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

static const char creator[] = "stiffaxis " STIFFAXIS_VERSION;

// --- writing -------------------------------------------------------------------------------------

static status open_door(const hdf5_door **out)
{
    status st = OK;
    door_function found = NULL;
    TRY(door_open("hdf5", HDF5_DOOR_SYMBOL, &found));
    *out = ((hdf5_door_table_function)found)();

done:
    return st;
}

static status put_root_text(const store *s, const char *name, const char *text)
{
    const hdf5_array array = hdf5_text_of(strlen(text));
    return s->door->put(s->file, "/", name, &array, text);
}

// the file's name and that under which it is written
static status choose_names(store *s, const char *path)
{
    status st = OK;
    char parent[DISK_MAX_PATH];
    TRY(disk_join(s->path, sizeof s->path, "%s", path));
    TRY(disk_join(s->work, sizeof s->work, "%s.tmp-%ld", path, (long)getpid()));
    TRY(disk_parent(path, parent, sizeof parent));
    if (access(parent, W_OK) != 0) {
        TRY(disk_fail(parent, "write into the directory"));
    }

done:
    return st;
}

status store_create(const char *path, store **out)
{
    status st = OK;
    store *s = NULL;
    TRY(TAKE(s, 1));
    s->reader = (store_reader){.child = -1, .channel = -1};
    s->first_rank = true;
    TRY(choose_names(s, path));
    TRY(open_door(&s->door));
    (void)unlink(s->work); // left behind by a killed run whose process number comes again
    TRY(s->door->create(s->work, &s->file));
    TRY(put_root_text(s, "creator", creator));
    TRY(put_root_text(s, "schema", STORE_SCHEMA));
    *out = s;
    s = NULL;

done:
    store_abandon(s);
    return st;
}

status store_create_shared(const char *path, store **out)
{
    status st = OK;
    int rank = 0, size = 1;
    store *s = NULL;
    *out = NULL;
    TRY(TAKE(s, 1));
    s->reader = (store_reader){.child = -1, .channel = -1};
    TRY(open_door(&s->door));
    s->door->ranks(&rank, &size);
    s->first_rank = rank == 0;
    TRY(s->door->agree(s->first_rank && path ? choose_names(s, path) : OK));
    s->door->tell(s->path, sizeof s->path);
    s->door->tell(s->work, sizeof s->work);
    if (s->path[0] == '\0') {
        goto done;
    }
    TRY(s->door->create_shared(s->work, &s->file));
    s->shared = true;
    TRY(put_root_text(s, "creator", creator));
    TRY(put_root_text(s, "schema", STORE_SCHEMA));
    *out = s;
    s = NULL;

done:
    store_abandon(s);
    return st;
}

// everything is in the file of that name: on disk for good, and under its own name
static status settle(const store *s)
{
    status st = OK;
    char parent[DISK_MAX_PATH];
    TRY(disk_sync(s->work));
    if (rename(s->work, s->path) != 0) {
        TRY(disk_fail(s->path, "rename the result to"));
    }
    TRY(disk_parent(s->path, parent, sizeof parent));
    TRY(disk_sync(parent));

done:
    return st;
}

static status commit_shared(store *s)
{
    status st = OK;
    hdf5_file *file = s->file;
    s->file = NULL;
    TRY(s->door->finish(file));
    TRY(s->door->agree(s->first_rank ? settle(s) : OK));

done:
    if (st != OK && s->first_rank) {
        (void)unlink(s->work);
    }
    store_abandon(s);
    return st;
}

status store_commit(store *s)
{
    if (s->shared) {
        return commit_shared(s);
    }
    status st = OK;
    void *image = NULL;
    size_t bytes = 0;
    char parent[DISK_MAX_PATH];
    TRY(s->door->image(s->file, &image, &bytes));
    TRY(disk_write(s->work, s->path, image, bytes));
    if (rename(s->work, s->path) != 0) {
        TRY(disk_fail(s->path, "rename the result to"));
    }
    TRY(disk_parent(s->path, parent, sizeof parent));
    TRY(disk_sync(parent));

done:
    free(image);
    store_abandon(s);
    return st;
}

void store_abandon(store *s)
{
    if (!s) {
        return;
    }
    if (s->file && !s->shared) { // all ranks close a shared file, or none: the process ends
        s->door->close(s->file);
    }
    if (s->file && s->first_rank) {
        (void)unlink(s->work); // gone already after a commit
    }
    free(s);
}

static status write_array(store *s, const char *name, int kind, int rank, const size_t *shape,
                          const void *data, const char *unit)
{
    hdf5_array array = {.kind = kind, .rank = rank};
    if (rank < 0 || rank > HDF5_MAX_RANK) {
        return status_fail(ERR_BUG, "the array '%s' has %d dimensions", name, rank);
    }
    for (int i = 0; i < rank; i++) {
        array.shape[i] = shape[i];
    }
    return s->door->write(s->file, name, &array, data, unit);
}

status store_real(store *s, const char *name, int rank, const size_t *shape, const double *data,
                  const char *unit)
{
    return write_array(s, name, HDF5_REAL, rank, shape, data, unit);
}

status store_make(store *s, const char *name, int rank, const size_t *shape, const char *unit)
{
    hdf5_array array = {.kind = HDF5_REAL, .rank = rank};
    memcpy(array.shape, shape, (size_t)rank * sizeof *shape);
    return s->door->make(s->file, name, &array, unit);
}

status store_rows(store *s, const char *name, size_t first, int rank, const size_t *shape,
                  const double *data)
{
    hdf5_array array = {.kind = HDF5_REAL, .rank = rank};
    memcpy(array.shape, shape, (size_t)rank * sizeof *shape);
    return s->door->rows(s->file, name, first, &array, data);
}

status store_integer(store *s, const char *name, int rank, const size_t *shape, const int *data)
{
    return write_array(s, name, HDF5_INTEGER, rank, shape, data, "-");
}

status store_text(store *s, const char *name, const char *text, size_t length)
{
    // HDF5 has no text of length 0: it is kept as a single NUL
    const bool none = length == 0;
    return write_array(s, name, HDF5_TEXT, 1, &(size_t){none ? 1 : length}, none ? "" : text, "-");
}

status store_grid(store *s, int npiece, const store_grid_piece *pieces)
{
    return store_grid_write(s->door, s->file, s->first_rank, npiece, pieces);
}
