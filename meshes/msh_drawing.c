// meshes/msh_drawing.c
// `msh:` as a source of sections: one mesh, read when it is opened.
#include "meshes/drawing.h"

#include "base/memory.h"
#include "meshes/msh.h"

#include <string.h>

static const size_t MOST_BYTES = (size_t)512 << 20;

static void msh_close(void *state)
{
    mesh *m = state;
    if (m) {
        mesh_free(m);
        free(m);
    }
}

static status msh_open(const drawing_files *files, const drawing_request *request, void **state)
{
    status st = OK;
    const msh_spec *spec = &files->msh;
    input_file file = {0};
    part_table parts = {0};
    raw_mesh raw = {0};
    mesh *m = NULL;

    TRY(parts_make("physical group", &spec->parts, request, &parts));
    TRY(input_file_read(request->directory, &spec->file, MOST_BYTES, &file));
    TRY(msh_read(&file, &parts, drawing_unit_size(spec->unit), &raw));
    TRY(TAKE(m, 1));
    TRY(raw_mesh_finish(&raw, m));
    *state = m;
    m = NULL;

done:
    msh_close(m);
    raw_mesh_free(&raw);
    input_file_free(&file);
    parts_free(&parts);
    return st;
}

static status msh_mesh(const void *state, int slice, const mesh_options *options, mesh *out)
{
    (void)slice;
    (void)options;
    return mesh_copy(state, out);
}

extern const drawing_kind msh_drawing;
const drawing_kind msh_drawing = {.open = msh_open, .close = msh_close, .mesh = msh_mesh};
