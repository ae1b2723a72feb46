// io/hdf5_door_module.c
// The module that speaks HDF5: scopes, files, and its table. MPI is linked (the build that PETSc
// uses) but never started here.
#include "io/hdf5_inside.h"

#include "base/memory.h"

#include <stdio.h>
#include <string.h>

// by which the memory of a new file grows
static const size_t growth_bytes = (size_t)1 << 20;

static herr_t take_first(unsigned n, const H5E_error2_t *error, void *reason)
{
    if (n == 0 && error->desc) {
        (void)snprintf(reason, 160, "%s", error->desc);
    }
    return 0;
}

void hdf5_check(hdf5_scope *s, herr_t code)
{
    if (code < 0 && !s->failed) {
        s->failed = true;
        (void)H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, take_first, s->reason);
    }
}

hid_t hdf5_keep(hdf5_scope *s, hid_t id)
{
    hdf5_check(s, id < 0 ? -1 : 0);
    if (id >= 0) {
        s->id[s->n++] = id;
    }
    return id;
}

status hdf5_leave(hdf5_scope *s, status code, const char *what, const char *name)
{
    while (s->n > 0) {
        s->n--;
        (void)H5Idec_ref(s->id[s->n]);
    }
    if (s->failed) {
        return status_fail(code, "HDF5 cannot %s '%s': %s", what, name,
                           s->reason[0] ? s->reason : "no reason given");
    }
    return OK;
}

static hid_t hdf5_text_type(hdf5_scope *s, size_t length, H5T_cset_t characters)
{
    const hid_t type = hdf5_keep(s, H5Tcopy(H5T_C_S1));
    hdf5_check(s, H5Tset_size(type, length ? length : 1));
    hdf5_check(s, H5Tset_strpad(type, H5T_STR_NULLPAD));
    hdf5_check(s, H5Tset_cset(type, characters));
    return type;
}

hid_t hdf5_array_type(hdf5_scope *s, const hdf5_array *array, H5T_cset_t characters)
{
    switch (array->kind) {
    case HDF5_REAL:
        return H5T_NATIVE_DOUBLE;
    case HDF5_INTEGER:
        return H5T_NATIVE_INT;
    case HDF5_LONG:
        return H5T_NATIVE_INT64;
    case HDF5_BYTE:
        return H5T_NATIVE_UINT8;
    default:
        return hdf5_text_type(s, array->shape[0], characters);
    }
}

hid_t hdf5_array_space(hdf5_scope *s, const hdf5_array *array)
{
    if (array->kind == HDF5_TEXT || array->rank == 0) {
        return hdf5_keep(s, H5Screate(H5S_SCALAR));
    }
    hsize_t shape[HDF5_MAX_RANK];
    for (int i = 0; i < array->rank; i++) {
        shape[i] = array->shape[i];
    }
    return hdf5_keep(s, H5Screate_simple(array->rank, shape, NULL));
}

// --- files ---------------------------------------------------------------------------------------

// Our renaming keeps readers and writers apart: no locks, which some file systems lack. Closing a
// file closes all in it.
static hid_t access_plist(hdf5_scope *s, bool create)
{
    const hid_t plist = hdf5_keep(s, H5Pcreate(H5P_FILE_ACCESS));
    if (create) {
        hdf5_check(s, H5Pset_fapl_core(plist, growth_bytes, 0));
    }
    hdf5_check(s, H5Pset_file_locking(plist, 0, 1));
    hdf5_check(s, H5Pset_fclose_degree(plist, H5F_CLOSE_STRONG));
    return plist;
}

static status open_file(const char *path, bool create, hdf5_file **out)
{
    status st = OK;
    hdf5_file *f = NULL;
    hdf5_scope s = {0};
    TRY(TAKE(f, 1));
    f->first_rank = true;
    const hid_t access = access_plist(&s, create);
    f->id = create ? H5Fcreate(path, H5F_ACC_EXCL, H5P_DEFAULT, access)
                   : H5Fopen(path, H5F_ACC_RDONLY, access);
    hdf5_check(&s, f->id < 0 ? -1 : 0);
    hdf5_check(&s, H5Fget_filesize(f->id, &f->bytes));
    if (s.failed && f->id >= 0) {
        (void)H5Fclose(f->id);
    }
    TRY(hdf5_leave(&s, create ? ERR_RESOURCE : ERR_FILE, create ? "create" : "open",
                   create ? path : "the file"));
    *out = f;
    f = NULL;

done:
    free(f);
    return st;
}

static status door_create(const char *path, hdf5_file **out)
{
    return open_file(path, true, out);
}

static status door_open_file(const char *path, hdf5_file **out)
{
    return open_file(path, false, out);
}

static status door_image(const hdf5_file *f, void **image, size_t *bytes)
{
    status st = OK;
    hdf5_scope s = {0};
    hdf5_check(&s, H5Fflush(f->id, H5F_SCOPE_GLOBAL));
    const ssize_t size = H5Fget_file_image(f->id, NULL, 0);
    hdf5_check(&s, size < 0 ? -1 : 0);
    TRY(hdf5_leave(&s, ERR_RESOURCE, "finish", "the file"));
    TRY(memory_take(image, (size_t)size, 1));
    hdf5_check(&s, H5Fget_file_image(f->id, *image, (size_t)size) == size ? 0 : -1);
    TRY(hdf5_leave(&s, ERR_RESOURCE, "finish", "the file"));
    *bytes = (size_t)size;

done:
    return st;
}

static void door_close(hdf5_file *f)
{
    (void)H5Fclose(f->id);
    free(f);
}

const hdf5_door *hdf5_door_table(void);

const hdf5_door *hdf5_door_table(void)
{
    static const hdf5_door table = {
        .create = door_create,
        .write = hdf5_write,
        .make = hdf5_make,
        .rows = hdf5_rows,
        .put = hdf5_put,
        .image = door_image,
        .close = door_close,
        .open = door_open_file,
        .has = hdf5_has,
        .look = hdf5_look,
        .read = hdf5_read,
        .get_text = hdf5_get_text,
        .ranks = hdf5_ranks,
        .tell = hdf5_tell,
        .agree = hdf5_agree,
        .create_shared = hdf5_create_shared,
        .finish = hdf5_finish,
    };
    // our messages say what failed: HDF5's own pages stay away, and so do plugins that a file may
    // ask for
    (void)H5Eset_auto2(H5E_DEFAULT, NULL, NULL);
    (void)H5PLset_loading_state(0);
    return &table;
}
