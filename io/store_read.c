// io/store_read.c
#include "io/store.h"

#include "base/memory.h"
#include "io/store_inside.h"

#include <limits.h>
#include <stdio.h>
#include <string.h>

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
    st = store_reader_start(path, STORE_SCHEMA, &s->reader);
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
