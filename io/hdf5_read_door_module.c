// io/hdf5_read_door_module.c
// Reading: what is read is judged first.
#include "io/hdf5_inside.h"

#include <stdio.h>
#include <string.h>

// deflate packs 1032 to 1 at best: a file that claims more is damaged
static const size_t pack_ratio_max = 1100;

// every step of the path is a plain link: a soft or external one may lead out of the file
bool hdf5_has(const hdf5_file *f, const char *name)
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
static bool storage_is_plain(hdf5_scope *s, const hdf5_file *f, hid_t set, size_t bytes)
{
    const hid_t plist = hdf5_keep(s, H5Dget_create_plist(set));
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

status hdf5_look(const hdf5_file *f, const char *name, hdf5_array *out)
{
    if (!hdf5_has(f, name)) {
        return status_fail(ERR_FILE, "there is no array '%s'", name);
    }
    hdf5_scope s = {0};
    size_t bytes = 0;
    *out = (hdf5_array){0};
    const hid_t set = hdf5_keep(&s, H5Dopen2(f->id, name, H5P_DEFAULT));
    const hid_t type = hdf5_keep(&s, H5Dget_type(set));
    const hid_t space = hdf5_keep(&s, H5Dget_space(set));
    out->kind = s.failed ? -1 : kind_of(type);
    bool ok = out->kind >= 0 && shape_of(space, out);
    if (ok && out->kind == HDF5_TEXT) {
        ok = out->rank == 0;
        *out = hdf5_text_of(H5Tget_size(type));
    }
    ok = ok && hdf5_array_bytes(out, &bytes) && (bytes == 0 || storage_is_plain(&s, f, set, bytes));
    const bool failed = s.failed;
    const status st = hdf5_leave(&s, ERR_FILE, "read", name);
    return ok || failed ? st : status_fail(ERR_FILE, "'%s' is of an impossible size or kind", name);
}

status hdf5_read(const hdf5_file *f, const char *name, const hdf5_array *array, void *data)
{
    hdf5_scope s = {0};
    size_t bytes = 0;
    const hid_t set = hdf5_keep(&s, H5Dopen2(f->id, name, H5P_DEFAULT));
    // texts come as they are
    const hid_t type = array->kind == HDF5_TEXT ? hdf5_keep(&s, H5Dget_type(set))
                                                : hdf5_array_type(&s, array, H5T_CSET_UTF8);
    if (hdf5_array_bytes(array, &bytes) && bytes > 0) {
        hdf5_check(&s, H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data));
    }
    return hdf5_leave(&s, ERR_FILE, "read", name);
}

status hdf5_get_text(const hdf5_file *f, const char *name, size_t size, char *text)
{
    hdf5_scope s = {0};
    memset(text, 0, size);
    const hid_t attribute = hdf5_keep(&s, H5Aopen(f->id, name, H5P_DEFAULT));
    const hid_t type = hdf5_keep(&s, H5Aget_type(attribute));
    const hid_t space = hdf5_keep(&s, H5Aget_space(attribute));
    if (!s.failed && kind_of(type) == HDF5_TEXT && H5Tget_size(type) < size &&
        H5Sget_simple_extent_npoints(space) == 1) {
        hdf5_check(&s, H5Aread(attribute, type, text));
    }
    return hdf5_leave(&s, ERR_FILE, "read the attribute", name);
}
