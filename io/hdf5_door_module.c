// io/hdf5_door_module.c
// The one place that speaks HDF5. MPI is linked (the build that PETSc uses) but never started.
#include "io/hdf5_door.h"

#include "base/memory.h"

#include <hdf5.h>
#include <stdio.h>
#include <string.h>

// indices from this size on are packed; what is smaller gains nothing
static const size_t pack_bytes = (size_t)1 << 18;
// rows of a packed array that lie together
static const size_t chunk_bytes = (size_t)1 << 20;
// by which the memory of a new file grows
static const size_t growth_bytes = (size_t)1 << 20;
// deflate packs 1032 to 1 at best: a file that claims more is damaged
static const size_t pack_ratio_max = 1100;

struct hdf5_file {
    hid_t id;
    hsize_t bytes; // of the file, when reading
};

// Identifiers to be closed together, and the reason of the first call that failed. A call that is
// given an invalid identifier fails too, so that one check at the end serves a whole function.
typedef struct scope {
    hid_t id[12];
    int n;
    bool failed;
    char reason[160];
} scope;

static herr_t take_first(unsigned n, const H5E_error2_t *error, void *reason)
{
    if (n == 0 && error->desc) {
        (void)snprintf(reason, 160, "%s", error->desc);
    }
    return 0;
}

static void check(scope *s, herr_t code)
{
    if (code < 0 && !s->failed) {
        s->failed = true;
        (void)H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, take_first, s->reason);
    }
}

static hid_t keep(scope *s, hid_t id)
{
    check(s, id < 0 ? -1 : 0);
    if (id >= 0) {
        s->id[s->n++] = id;
    }
    return id;
}

static status leave(scope *s, status code, const char *what, const char *name)
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

static hid_t text_type(scope *s, size_t length, H5T_cset_t characters)
{
    const hid_t type = keep(s, H5Tcopy(H5T_C_S1));
    check(s, H5Tset_size(type, length ? length : 1));
    check(s, H5Tset_strpad(type, H5T_STR_NULLPAD));
    check(s, H5Tset_cset(type, characters));
    return type;
}

// on disk as in memory; the file says which byte order that is
static hid_t array_type(scope *s, const hdf5_array *array, H5T_cset_t characters)
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
        return text_type(s, array->shape[0], characters);
    }
}

static hid_t array_space(scope *s, const hdf5_array *array)
{
    if (array->kind == HDF5_TEXT || array->rank == 0) {
        return keep(s, H5Screate(H5S_SCALAR));
    }
    hsize_t shape[HDF5_MAX_RANK];
    for (int i = 0; i < array->rank; i++) {
        shape[i] = array->shape[i];
    }
    return keep(s, H5Screate_simple(array->rank, shape, NULL));
}

// --- files ---------------------------------------------------------------------------------------

// Our renaming keeps readers and writers apart: no locks, which some file systems lack. Closing a
// file closes all in it.
static hid_t access_plist(scope *s, bool create)
{
    const hid_t plist = keep(s, H5Pcreate(H5P_FILE_ACCESS));
    if (create) {
        check(s, H5Pset_fapl_core(plist, growth_bytes, 0));
    }
    check(s, H5Pset_file_locking(plist, 0, 1));
    check(s, H5Pset_fclose_degree(plist, H5F_CLOSE_STRONG));
    return plist;
}

static status open_file(const char *path, bool create, hdf5_file **out)
{
    status st = OK;
    hdf5_file *f = NULL;
    scope s = {0};
    TRY(TAKE(f, 1));
    const hid_t access = access_plist(&s, create);
    f->id = create ? H5Fcreate(path, H5F_ACC_EXCL, H5P_DEFAULT, access)
                   : H5Fopen(path, H5F_ACC_RDONLY, access);
    check(&s, f->id < 0 ? -1 : 0);
    check(&s, H5Fget_filesize(f->id, &f->bytes));
    if (s.failed && f->id >= 0) {
        (void)H5Fclose(f->id);
    }
    TRY(leave(&s, create ? ERR_RESOURCE : ERR_FILE, create ? "create" : "open",
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
    scope s = {0};
    check(&s, H5Fflush(f->id, H5F_SCOPE_GLOBAL));
    const ssize_t size = H5Fget_file_image(f->id, NULL, 0);
    check(&s, size < 0 ? -1 : 0);
    TRY(leave(&s, ERR_RESOURCE, "finish", "the file"));
    TRY(memory_take(image, (size_t)size, 1));
    check(&s, H5Fget_file_image(f->id, *image, (size_t)size) == size ? 0 : -1);
    TRY(leave(&s, ERR_RESOURCE, "finish", "the file"));
    *bytes = (size_t)size;

done:
    return st;
}

static void door_close(hdf5_file *f)
{
    (void)H5Fclose(f->id);
    free(f);
}

// --- writing -------------------------------------------------------------------------------------

// groups on the way to a name are made as needed
static hid_t parents_plist(scope *s)
{
    const hid_t plist = keep(s, H5Pcreate(H5P_LINK_CREATE));
    check(s, H5Pset_create_intermediate_group(plist, 1));
    return plist;
}

static hid_t dataset_plist(scope *s, const hdf5_array *array, size_t bytes)
{
    const hid_t plist = keep(s, H5Pcreate(H5P_DATASET_CREATE));
    // the same run gives the same bytes: no times
    check(s, H5Pset_obj_track_times(plist, 0));
    // packing pays for indices, which repeat; doubles would cost time and stay as long
    if (bytes >= pack_bytes && (array->kind == HDF5_INTEGER || array->kind == HDF5_LONG)) {
        const size_t row = bytes / array->shape[0];
        const size_t rows = row < chunk_bytes ? chunk_bytes / row : 1;
        hsize_t chunk[HDF5_MAX_RANK];
        for (int i = 0; i < array->rank; i++) {
            chunk[i] = array->shape[i];
        }
        chunk[0] = rows < array->shape[0] ? rows : array->shape[0];
        check(s, H5Pset_chunk(plist, array->rank, chunk));
        check(s, H5Pset_shuffle(plist));
        check(s, H5Pset_deflate(plist, 1));
    }
    return plist;
}

// texts are ASCII and of fixed length: the form in which VTK wants its Type
static void write_attribute(scope *s, hid_t object, const char *name, const hdf5_array *array,
                            const void *data)
{
    const hid_t type = array_type(s, array, H5T_CSET_ASCII);
    const hid_t space = array_space(s, array);
    const hid_t attribute =
        keep(s, H5Acreate2(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT));
    check(s, H5Awrite(attribute, type, data));
}

static status door_write(hdf5_file *f, const char *name, const hdf5_array *array, const void *data,
                         const char *unit)
{
    size_t bytes = 0;
    if (!hdf5_array_bytes(array, &bytes)) {
        return status_fail(ERR_RESOURCE, "the array '%s' is too large to be stored", name);
    }
    scope s = {0};
    const hdf5_array word = hdf5_text_of(strlen(unit));
    const hid_t type = array_type(&s, array, H5T_CSET_UTF8);
    const hid_t space = array_space(&s, array);
    const hid_t layout = dataset_plist(&s, array, bytes);
    const hid_t set =
        keep(&s, H5Dcreate2(f->id, name, type, space, parents_plist(&s), layout, H5P_DEFAULT));
    if (bytes > 0) {
        check(&s, H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data));
    }
    write_attribute(&s, set, "unit", &word, unit);
    return leave(&s, ERR_RESOURCE, "write", name);
}

static status door_put(hdf5_file *f, const char *group, const char *name, const hdf5_array *array,
                       const void *data)
{
    scope s = {0};
    const bool there = strcmp(group, "/") == 0 || H5Lexists(f->id, group, H5P_DEFAULT) > 0;
    const hid_t id =
        keep(&s, there ? H5Gopen2(f->id, group, H5P_DEFAULT)
                       : H5Gcreate2(f->id, group, parents_plist(&s), H5P_DEFAULT, H5P_DEFAULT));
    write_attribute(&s, id, name, array, data);
    return leave(&s, ERR_RESOURCE, "write the attribute", name);
}

// --- reading -------------------------------------------------------------------------------------

// every step of the path is a plain link: a soft or external one may lead out of the file
static bool door_has(const hdf5_file *f, const char *name)
{
    char path[256];
    const size_t length = strlen(name);
    bool plain = length > 0 && length < sizeof path;
    for (size_t i = 1; plain && i <= length; i++) {
        H5L_info_t link;
        if (name[i] == '/' || name[i] == '\0') {
            (void)snprintf(path, sizeof path, "%.*s", (int)i, name);
            plain = H5Lexists(f->id, path, H5P_DEFAULT) > 0 &&
                    H5Lget_info(f->id, path, &link, H5P_DEFAULT) >= 0 && link.type == H5L_TYPE_HARD;
        }
    }
    return plain;
}

static bool filters_are_ours(hid_t plist)
{
    const int n = H5Pget_nfilters(plist);
    bool ok = n >= 0 && n <= 2;
    for (int i = 0; ok && i < n; i++) {
        unsigned flags = 0, config = 0;
        size_t count = 0;
        const H5Z_filter_t filter =
            H5Pget_filter2(plist, (unsigned)i, &flags, &count, NULL, 0, NULL, &config);
        ok = filter == H5Z_FILTER_DEFLATE || filter == H5Z_FILTER_SHUFFLE;
    }
    return ok;
}

// the data lie in this file, and there are enough bytes for the shape that is claimed
static bool storage_is_plain(scope *s, const hdf5_file *f, hid_t set, size_t bytes)
{
    const hid_t plist = keep(s, H5Dget_create_plist(set));
    const H5D_layout_t layout = H5Pget_layout(plist);
    const hsize_t stored = H5Dget_storage_size(set);
    const bool chunked = layout == H5D_CHUNKED;
    const bool enough = (chunked ? bytes / pack_ratio_max : bytes) <= stored;
    return (chunked || layout == H5D_CONTIGUOUS || layout == H5D_COMPACT) && enough &&
           stored <= f->bytes && H5Pget_external_count(plist) == 0 && filters_are_ours(plist);
}

// -1: none of ours
static int kind_of(hid_t type)
{
    const size_t size = H5Tget_size(type);
    switch (H5Tget_class(type)) {
    case H5T_FLOAT:
        return size == 8 ? HDF5_REAL : -1;
    case H5T_INTEGER:
        return size == 1 ? HDF5_BYTE : size == 4 ? HDF5_INTEGER : size == 8 ? HDF5_LONG : -1;
    case H5T_STRING:
        return H5Tis_variable_str(type) == 0 ? HDF5_TEXT : -1;
    default:
        return -1;
    }
}

static bool shape_of(hid_t space, hdf5_array *out)
{
    hsize_t shape[HDF5_MAX_RANK] = {0};
    const H5S_class_t class = H5Sget_simple_extent_type(space);
    out->rank = H5Sget_simple_extent_ndims(space);
    if ((class != H5S_SIMPLE && class != H5S_SCALAR) || out->rank < 0 ||
        out->rank > HDF5_MAX_RANK || H5Sget_simple_extent_dims(space, shape, NULL) < 0) {
        return false;
    }
    for (int i = 0; i < out->rank; i++) {
        out->shape[i] = (size_t)shape[i];
    }
    return true;
}

static status door_look(const hdf5_file *f, const char *name, hdf5_array *out)
{
    if (!door_has(f, name)) {
        return status_fail(ERR_FILE, "there is no array '%s'", name);
    }
    scope s = {0};
    size_t bytes = 0;
    *out = (hdf5_array){0};
    const hid_t set = keep(&s, H5Dopen2(f->id, name, H5P_DEFAULT));
    const hid_t type = keep(&s, H5Dget_type(set));
    const hid_t space = keep(&s, H5Dget_space(set));
    out->kind = s.failed ? -1 : kind_of(type);
    bool ok = out->kind >= 0 && shape_of(space, out);
    if (ok && out->kind == HDF5_TEXT) {
        ok = out->rank == 0;
        *out = hdf5_text_of(H5Tget_size(type));
    }
    ok = ok && hdf5_array_bytes(out, &bytes) && (bytes == 0 || storage_is_plain(&s, f, set, bytes));
    const bool failed = s.failed;
    const status st = leave(&s, ERR_FILE, "read", name);
    return ok || failed ? st : status_fail(ERR_FILE, "'%s' is of an impossible size or kind", name);
}

static status door_read(const hdf5_file *f, const char *name, const hdf5_array *array, void *data)
{
    scope s = {0};
    size_t bytes = 0;
    const hid_t set = keep(&s, H5Dopen2(f->id, name, H5P_DEFAULT));
    // texts come as they are
    const hid_t type = array->kind == HDF5_TEXT ? keep(&s, H5Dget_type(set))
                                                : array_type(&s, array, H5T_CSET_UTF8);
    if (hdf5_array_bytes(array, &bytes) && bytes > 0) {
        check(&s, H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data));
    }
    return leave(&s, ERR_FILE, "read", name);
}

static status door_get_text(const hdf5_file *f, const char *name, size_t size, char *text)
{
    scope s = {0};
    memset(text, 0, size);
    const hid_t attribute = keep(&s, H5Aopen(f->id, name, H5P_DEFAULT));
    const hid_t type = keep(&s, H5Aget_type(attribute));
    const hid_t space = keep(&s, H5Aget_space(attribute));
    if (!s.failed && kind_of(type) == HDF5_TEXT && H5Tget_size(type) < size &&
        H5Sget_simple_extent_npoints(space) == 1) {
        check(&s, H5Aread(attribute, type, text));
    }
    return leave(&s, ERR_FILE, "read the attribute", name);
}

const hdf5_door *hdf5_door_table(void);

const hdf5_door *hdf5_door_table(void)
{
    static const hdf5_door table = {
        .create = door_create,
        .write = door_write,
        .put = door_put,
        .image = door_image,
        .close = door_close,
        .open = door_open_file,
        .has = door_has,
        .look = door_look,
        .read = door_read,
        .get_text = door_get_text,
    };
    // our messages say what failed: HDF5's own pages stay away, and so do plugins that a file may
    // ask for
    (void)H5Eset_auto2(H5E_DEFAULT, NULL, NULL);
    (void)H5PLset_loading_state(0);
    return &table;
}
