// tests/msh.h
// Meshes as files: read through the drawing, as a case would.
#pragma once

#include "base/mesh.h"
#include "meshes/drawing.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { MSH_MATERIALS = 2 };

static const material msh_materials[MSH_MATERIALS] = {{.name = "soft", .E = 1e6, .nu = 0.3},
                                                      {.name = "stiff", .E = 5e6, .nu = 0.4}};

// tests/files
static inline const char *files_folder(char path[512])
{
    const char *source = getenv("STIFFAXIS_SOURCE");
    (void)snprintf(path, 512, "%s/tests/files", source ? source : ".");
    return path;
}

static inline status msh_open_with(const char *directory, const char *name, int nmaterial,
                                   const material *materials, key_list parts, int unit, mesh *out)
{
    drawing_files files = {0};
    drawing *d = NULL;
    files.msh = (msh_spec){.at = {3, 3}, .file = {.text = name, .at = {3, 9}}, .unit = unit};
    files.msh.parts = parts;
    const drawing_request request = {
        .directory = directory, .nmaterial = nmaterial, .materials = materials};
    status_clear();
    status st = drawing_open(&files, &request, &d);
    if (st == OK) {
        const mesh_options unused = {.order = 1};
        st = drawing_mesh(d, 0, &unused, out);
    }
    drawing_free(d);
    return st;
}

// in metres, parts named soft and stiff
static inline status msh_open_file(const char *directory, const char *name, mesh *out)
{
    return msh_open_with(directory, name, MSH_MATERIALS, msh_materials, (key_list){0}, UNIT_M, out);
}

// the same of a text
static inline status msh_open_text(const char *text, size_t count, mesh *out)
{
    char folder[] = "/tmp/stiffaxis-msh-XXXXXX", path[64];
    if (!mkdtemp(folder)) {
        return ERR_BUG;
    }
    (void)snprintf(path, sizeof path, "%s/a.msh", folder);
    FILE *f = fopen(path, "wb");
    const bool whole = f && fwrite(text, 1, count, f) == count;
    if (f) {
        (void)fclose(f);
    }
    const status st = whole ? msh_open_file(folder, "a.msh", out) : ERR_BUG;
    (void)remove(path);
    (void)rmdir(folder);
    return st;
}
