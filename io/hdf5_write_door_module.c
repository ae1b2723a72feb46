// io/hdf5_write_door_module.c
// Writing, by one process or by all ranks together. Of a shared file everything but `rows` is
// called by all ranks alike.
#include "io/hdf5_inside.h"

#include <stdio.h>
#include <string.h>

// indices from this size on are packed; what is smaller gains nothing
static const size_t pack_bytes = (size_t)1 << 18;
// rows of a packed array that lie together
static const size_t chunk_bytes = (size_t)1 << 20;

// groups on the way to a name are made as needed
static hid_t parents_plist(hdf5_scope *s)
{
    const hid_t plist = hdf5_keep(s, H5Pcreate(H5P_LINK_CREATE));
    hdf5_check(s, H5Pset_create_intermediate_group(plist, 1));
    return plist;
}

static hid_t dataset_plist(hdf5_scope *s, const hdf5_array *array, size_t bytes)
{
    const hid_t plist = hdf5_keep(s, H5Pcreate(H5P_DATASET_CREATE));
    // the same run gives the same bytes: no times
    hdf5_check(s, H5Pset_obj_track_times(plist, 0));
    // packing pays for indices, which repeat; doubles would cost time and stay as long
    if (bytes >= pack_bytes && (array->kind == HDF5_INTEGER || array->kind == HDF5_LONG)) {
        const size_t row = bytes / array->shape[0];
        const size_t rows = row < chunk_bytes ? chunk_bytes / row : 1;
        hsize_t chunk[HDF5_MAX_RANK];
        for (int i = 0; i < array->rank; i++) {
            chunk[i] = array->shape[i];
        }
        chunk[0] = rows < array->shape[0] ? rows : array->shape[0];
        hdf5_check(s, H5Pset_chunk(plist, array->rank, chunk));
        hdf5_check(s, H5Pset_shuffle(plist));
        hdf5_check(s, H5Pset_deflate(plist, 1));
    }
    return plist;
}

// texts are ASCII and of fixed length: the form in which VTK wants its Type
static void write_attribute(hdf5_scope *s, hid_t object, const char *name, const hdf5_array *array,
                            const void *data)
{
    const hid_t type = hdf5_array_type(s, array, H5T_CSET_ASCII);
    const hid_t space = hdf5_array_space(s, array);
    const hid_t attribute =
        hdf5_keep(s, H5Acreate2(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT));
    hdf5_check(s, H5Awrite(attribute, type, data));
}

// the file keeps what went wrong on this rank until all know of it: the others go on meanwhile
static status hold_back(hdf5_file *f, status st)
{
    if (st != OK && f->shared && f->failed == OK) {
        f->failed = st;
        (void)snprintf(f->reason, sizeof f->reason, "%s", status_message());
    }
    if (st != OK && f->shared) {
        status_clear();
        return OK;
    }
    return st;
}

static bool fits(const hdf5_file *f, const hdf5_array *array, size_t *bytes)
{
    *bytes = hdf5_kind_size(array->kind);
    for (int i = 0; i < array->rank; i++) {
        *bytes *= array->shape[i];
    }
    size_t checked;
    return f->shared || hdf5_array_bytes(array, &checked);
}

// an open array of this shape, without values
static hid_t make_array(hdf5_scope *s, hdf5_file *f, const char *name, const hdf5_array *array,
                        size_t bytes, const char *unit)
{
    const hdf5_array word = hdf5_text_of(strlen(unit));
    const hid_t type = hdf5_array_type(s, array, H5T_CSET_UTF8);
    const hid_t space = hdf5_array_space(s, array);
    // what several ranks write is not packed
    const hid_t layout = dataset_plist(s, array, f->shared ? 0 : bytes);
    const hid_t set =
        hdf5_keep(s, H5Dcreate2(f->id, name, type, space, parents_plist(s), layout, H5P_DEFAULT));
    write_attribute(s, set, "unit", &word, unit);
    return set;
}

status hdf5_write(hdf5_file *f, const char *name, const hdf5_array *array, const void *data,
                  const char *unit)
{
    size_t bytes = 0;
    if (!fits(f, array, &bytes)) {
        return status_fail(ERR_RESOURCE, "the array '%s' is too large to be stored", name);
    }
    hdf5_scope s = {0};
    const hid_t set = make_array(&s, f, name, array, bytes, unit);
    if (bytes > 0 && f->first_rank) {
        const hid_t type = hdf5_array_type(&s, array, H5T_CSET_UTF8);
        hdf5_check(&s, H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data));
    }
    return hold_back(f, hdf5_leave(&s, ERR_RESOURCE, "write", name));
}

status hdf5_make(hdf5_file *f, const char *name, const hdf5_array *array, const char *unit)
{
    size_t bytes = 0;
    if (!fits(f, array, &bytes)) {
        return status_fail(ERR_RESOURCE, "the array '%s' is too large to be stored", name);
    }
    hdf5_scope s = {0};
    (void)make_array(&s, f, name, array, bytes, unit);
    return hold_back(f, hdf5_leave(&s, ERR_RESOURCE, "make room for", name));
}

status hdf5_rows(hdf5_file *f, const char *name, size_t first, const hdf5_array *array,
                 const void *data)
{
    size_t bytes = 0;
    if (!fits(f, array, &bytes)) {
        return status_fail(ERR_RESOURCE, "the array '%s' is too large to be stored", name);
    }
    if (bytes == 0) {
        return OK;
    }
    hdf5_scope s = {0};
    hsize_t start[HDF5_MAX_RANK] = {first}, count[HDF5_MAX_RANK] = {0};
    for (int i = 0; i < array->rank; i++) {
        count[i] = array->shape[i];
    }
    const hid_t set = hdf5_keep(&s, H5Dopen2(f->id, name, H5P_DEFAULT));
    const hid_t type = hdf5_array_type(&s, array, H5T_CSET_UTF8);
    const hid_t here = hdf5_array_space(&s, array);
    const hid_t there = hdf5_keep(&s, H5Dget_space(set));
    hdf5_check(&s, H5Sselect_hyperslab(there, H5S_SELECT_SET, start, NULL, count, NULL));
    hdf5_check(&s, H5Dwrite(set, type, here, there, H5P_DEFAULT, data));
    return hold_back(f, hdf5_leave(&s, ERR_RESOURCE, "write", name));
}

status hdf5_put(hdf5_file *f, const char *group, const char *name, const hdf5_array *array,
                const void *data)
{
    hdf5_scope s = {0};
    const bool there = strcmp(group, "/") == 0 || H5Lexists(f->id, group, H5P_DEFAULT) > 0;
    const hid_t id = hdf5_keep(
        &s, there ? H5Gopen2(f->id, group, H5P_DEFAULT)
                  : H5Gcreate2(f->id, group, parents_plist(&s), H5P_DEFAULT, H5P_DEFAULT));
    write_attribute(&s, id, name, array, data);
    return hold_back(f, hdf5_leave(&s, ERR_RESOURCE, "write the attribute", name));
}
