// io/store.c
#include "io/store.h"

#include "base/door.h"
#include "base/memory.h"
#include "io/disk.h"
#include "io/store_grid.h"
#include "io/store_reader.h"

#include <limits.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

static const char schema[] = "stiffaxis/result/2";
static const char creator[] = "stiffaxis " STIFFAXIS_VERSION;

struct store {
    char path[DISK_MAX_PATH - 64]; // room for ".tmp-PID"
    char work[DISK_MAX_PATH];
    const hdf5_door *door; // writing
    hdf5_file *file;
    store_reader reader; // reading
};

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

status store_create(const char *path, store **out)
{
    status st = OK;
    char parent[DISK_MAX_PATH];
    store *s = NULL;
    TRY(TAKE(s, 1));
    s->reader = (store_reader){.child = -1, .channel = -1};
    TRY(disk_join(s->path, sizeof s->path, "%s", path));
    TRY(disk_join(s->work, sizeof s->work, "%s.tmp-%ld", path, (long)getpid()));
    TRY(disk_parent(path, parent, sizeof parent));
    if (access(parent, W_OK) != 0) {
        TRY(disk_fail(parent, "write into the directory"));
    }
    TRY(open_door(&s->door));
    (void)unlink(s->work); // left behind by a killed run whose process number comes again
    TRY(s->door->create(s->work, &s->file));
    TRY(put_root_text(s, "creator", creator));
    TRY(put_root_text(s, "schema", schema));
    *out = s;
    s = NULL;

done:
    store_abandon(s);
    return st;
}

status store_commit(store *s)
{
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
    if (s->file) {
        s->door->close(s->file);
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
    return store_grid_write(s->door, s->file, npiece, pieces);
}

// --- reading -------------------------------------------------------------------------------------

// the reader's words with the file's name in front
static status blame_file(const store *s, status code)
{
    char words[READER_MAX_MESSAGE];
    (void)snprintf(words, sizeof words, "%.*s", READER_MAX_MESSAGE - 1, status_message());
    status_clear();
    return status_fail(code, "%s: %s", s->path, words);
}

status store_open(const char *path, store **out)
{
    status st = OK;
    store *s = NULL;
    TRY(TAKE(s, 1));
    s->reader = (store_reader){.child = -1, .channel = -1};
    TRY(disk_join(s->path, sizeof s->path, "%s", path));
    TRY(store_sniff(path));
    st = store_reader_start(path, schema, &s->reader);
    if (st != OK) {
        TRY(blame_file(s, st));
    }
    *out = s;
    s = NULL;

done:
    store_close(s);
    return st;
}

bool store_has(const store *s, const char *name)
{
    return store_reader_has(&s->reader, name);
}

static status read_array(const store *s, const char *name, hdf5_array *array, void **data)
{
    const status st = store_reader_get(&s->reader, name, array, data);
    return st == OK ? OK : blame_file(s, st);
}

static status read_kind(const store *s, const char *name, int kind, hdf5_array *array, void **data)
{
    status st = OK;
    TRY(read_array(s, name, array, data));
    if (array->kind != kind) {
        free(*data);
        *data = NULL;
        *array = (hdf5_array){0};
        TRY(status_fail(ERR_FILE, "%s: damaged: '%s' is of another kind", s->path, name));
    }

done:
    return st;
}

static void give_shape(const hdf5_array *array, int *rank, size_t shape[4])
{
    *rank = array->rank;
    for (int i = 0; i < HDF5_MAX_RANK; i++) {
        shape[i] = i < array->rank ? array->shape[i] : 0;
    }
}

status store_read_real(const store *s, const char *name, int *rank, size_t shape[4], double **data)
{
    hdf5_array array = {0};
    void *bytes = NULL;
    const status st = read_kind(s, name, HDF5_REAL, &array, &bytes);
    give_shape(&array, rank, shape);
    *data = bytes;
    return st;
}

// the grid's indices are kept in other widths
static bool item_as_int(const hdf5_array *array, const void *data, size_t i, int *out)
{
    const int64_t wide = array->kind == HDF5_BYTE      ? ((const uint8_t *)data)[i]
                         : array->kind == HDF5_INTEGER ? ((const int *)data)[i]
                                                       : ((const int64_t *)data)[i];
    *out = (int)wide;
    return wide >= INT_MIN && wide <= INT_MAX;
}

status store_read_integer(const store *s, const char *name, int *rank, size_t shape[4], int **data)
{
    status st = OK;
    hdf5_array array = {0};
    void *bytes = NULL;
    size_t size = 0;
    *data = NULL;
    TRY(read_array(s, name, &array, &bytes));
    bool ok = array.kind != HDF5_REAL && array.kind != HDF5_TEXT;
    const size_t count = hdf5_array_bytes(&array, &size) ? size / hdf5_kind_size(array.kind) : 0;
    TRY(TAKE(*data, count));
    for (size_t i = 0; ok && i < count; i++) {
        ok = item_as_int(&array, bytes, i, &(*data)[i]);
    }
    if (!ok) {
        free(*data);
        *data = NULL;
        TRY(status_fail(ERR_FILE, "%s: damaged: '%s' is of another kind", s->path, name));
    }

done:
    free(bytes);
    give_shape(&array, rank, shape);
    return st;
}

status store_read_text(const store *s, const char *name, char **text, size_t *length)
{
    hdf5_array array = {0};
    void *bytes = NULL;
    const status st = read_kind(s, name, HDF5_TEXT, &array, &bytes);
    *text = bytes;
    *length = array.shape[0];
    if (*text && *length == 1 && (*text)[0] == '\0') {
        *length = 0;
    }
    return st;
}

void store_close(store *s)
{
    if (s) {
        store_reader_stop(&s->reader);
    }
    free(s);
}
