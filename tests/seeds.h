// tests/seeds.h
// Sound files of tests/files as seeds of mutants, and readers of them.
#pragma once

#include "tests/fuzz/mutate.h"
#include "tests/msh.h"

enum { MOST_SEEDS = 8, SEED_BYTES = 1 << 16 };

typedef struct seed_files {
    int count;
    mutant_seed seed[MOST_SEEDS];
} seed_files;

static inline void seed_add_text(seed_files *s, const char *text)
{
    unsigned char *bytes = malloc(strlen(text) + 1);
    if (bytes) {
        memcpy(bytes, text, strlen(text) + 1);
        s->seed[s->count++] = (mutant_seed){.bytes = bytes, .count = strlen(text)};
    }
}

static inline void seed_add_file(seed_files *s, const char *name)
{
    char path[640], folder[512];
    (void)snprintf(path, sizeof path, "%s/%s", files_folder(folder), name);
    FILE *f = fopen(path, "rb");
    unsigned char *bytes = malloc(SEED_BYTES);
    if (f && bytes) {
        s->seed[s->count++] =
            (mutant_seed){.bytes = bytes, .count = fread(bytes, 1, SEED_BYTES, f)};
        bytes = NULL;
    }
    if (f) {
        (void)fclose(f);
    }
    free(bytes);
}

static inline void seeds_free(seed_files *s)
{
    for (int i = 0; i < s->count; i++) {
        free((void *)(size_t)s->seed[i].bytes);
    }
    s->count = 0;
}

static inline seed_files msh_seeds(void)
{
    seed_files s = {0};
    seed_add_file(&s, "tongue_41_text_2.msh");
    seed_add_file(&s, "tongue_41_bytes_3.msh");
    seed_add_file(&s, "tongue_22_text_1.msh");
    seed_add_file(&s, "tongue_22_bytes_4.msh");
    seed_add_text(&s, "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n2 1 \"soft\"\n"
                      "$EndPhysicalNames\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n"
                      "$EndNodes\n$Elements\n2\n1 2 2 1 1 1 2 3\n2 2 2 1 1 1 3 4\n$EndElements\n"
                      "$ElementData\n1\n\"plane_angle_deg\"\n1\n0.0\n3\n0\n1\n2\n1 90\n2 5\n"
                      "$EndElementData\n$ElementData\n1\n\"axes\"\n1\n0.0\n3\n0\n9\n0\n"
                      "$EndElementData\n");
    return s;
}

static inline status msh_mutant(const char *directory, const char *name, void *context)
{
    mesh m = {0};
    (void)context;
    const status st = msh_open_file(directory, name, &m);
    mesh_free(&m);
    return st;
}

static inline status step_mutant(const char *directory, const char *name, void *context)
{
    const material both[2] = {{.name = "jacket", .E = 1e6, .nu = 0.3},
                              {.name = "core", .E = 5e6, .nu = 0.4}};
    drawing_files files = {0};
    drawing *d = NULL;
    mesh m = {0};
    files.step = (step_spec){.at = {3, 3},
                             .file = {.text = name, .at = {3, 9}},
                             .origin = {10e-3, 20e-3, 30e-3},
                             .normal = {1, 0, 0},
                             .x_axis = {0, 1, 0}};
    const drawing_request request = {.directory = directory, .nmaterial = 2, .materials = both};
    const mesh_options options = {.order = 2, .size = 2e-3};
    (void)context;
    status st = drawing_open(&files, &request, &d);
    if (st == OK) {
        st = drawing_mesh(d, 0, &options, &m);
    }
    drawing_free(d);
    mesh_free(&m);
    return st;
}
