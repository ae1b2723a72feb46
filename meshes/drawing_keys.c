// meshes/drawing_keys.c
#include "meshes/drawing.h"

enum { MOST_PARTS = 1000, LAST_SLICE = 99999999 };

#define COUNT(keys) ((int)(sizeof(keys) / sizeof *(keys)))

static const key part_key_list[] = {
    {.name = "name",
     .kind = KEY_NAME,
     .one_of = 1,
     .offset = offsetof(part_spec, name),
     .about = "of a physical group, a layer or a body in the file"},
    {.name = "colour",
     .kind = KEY_NAME,
     .one_of = 1,
     .offset = offsetof(part_spec, colour),
     .about = "'#rrggbb'"},
    {.name = "material",
     .kind = KEY_NAME,
     .required = true,
     .offset = offsetof(part_spec, material),
     .about = "a name from `materials`, or none"},
};

static const key_table part_keys = {.name = "part",
                                    .size = sizeof(part_spec),
                                    .nkey = COUNT(part_key_list),
                                    .keys = part_key_list,
                                    .about = "which part of the file is of which material"};

#define FILE_KEY(type, words)                                                                      \
    {                                                                                              \
        .name = "file", .kind = KEY_NAME, .required = true, .offset = offsetof(type, file),        \
        .about = words                                                                             \
    }

#define PARTS_KEY(type)                                                                            \
    {                                                                                              \
        .name = "parts", .kind = KEY_LIST, .max_count = MOST_PARTS,                                \
        .offset = offsetof(type, parts), .table = &part_keys,                                      \
        .about = "materials of the file's parts; a part named like a material needs none"          \
    }

#define UNIT_KEY(type)                                                                             \
    {                                                                                              \
        .name = "unit", .kind = KEY_CHOICE, .choices = "mm|m|cm|um|in", .initial = "mm",           \
        .offset = offsetof(type, unit), .about = "of the lengths in the file"                      \
    }

static const key png_key_list[] = {
    FILE_KEY(png_spec, "an image, or a stack of them: slice_%03d.png"),
    PARTS_KEY(png_spec),
    {.name = "pitch",
     .kind = KEY_VECTOR,
     .dimension = DIM_LENGTH,
     .min = 1e-9,
     .max = 1,
     .count = 2,
     .required = true,
     .offset = offsetof(png_spec, pitch),
     .about = "size of a pixel along x and y"},
    {.name = "layer",
     .kind = KEY_REAL,
     .dimension = DIM_LENGTH,
     .min = 1e-9,
     .max = 1,
     .offset = offsetof(png_spec, layer),
     .about = "thickness of a slice of a stack"},
    {.name = "first",
     .kind = KEY_INTEGER,
     .max = LAST_SLICE,
     .offset = offsetof(png_spec, first),
     .about = "number of a stack's first slice, with `last`; without both it is 0 or 1, and the "
              "files that are there are counted"},
    {.name = "last",
     .kind = KEY_INTEGER,
     .max = LAST_SLICE,
     .offset = offsetof(png_spec, last),
     .about = "number of a stack's last slice"},
    {.name = "boundaries",
     .kind = KEY_CHOICE,
     .choices = "pixels|smoothed",
     .initial = "pixels",
     .offset = offsetof(png_spec, boundaries),
     .about = "along the pixels' edges, or smoothed by less than a pixel"},
};

const key_table png_keys = {.name = "png",
                            .size = sizeof(png_spec),
                            .nkey = COUNT(png_key_list),
                            .keys = png_key_list,
                            .about = "printed slices, one colour one material"};

static const key msh_key_list[] = {FILE_KEY(msh_spec, "MSH 2.2 or 4.1"), PARTS_KEY(msh_spec),
                                   UNIT_KEY(msh_spec)};

const key_table msh_keys = {.name = "msh",
                            .size = sizeof(msh_spec),
                            .nkey = COUNT(msh_key_list),
                            .keys = msh_key_list,
                            .about = "a gmsh mesh of the section"};

static const key step_key_list[] = {
    FILE_KEY(step_spec, "a STEP file"),
    PARTS_KEY(step_spec),
    {.name = "origin",
     .kind = KEY_VECTOR,
     .dimension = DIM_LENGTH,
     .min = -1e3,
     .max = 1e3,
     .count = 3,
     .initial = "[0, 0, 0]",
     .offset = offsetof(step_spec, origin),
     .about = "a point of the cutting plane, the section's origin"},
    {.name = "normal",
     .kind = KEY_VECTOR,
     .count = 3,
     .initial = "[0, 0, 1]",
     .offset = offsetof(step_spec, normal),
     .about = "direction of the rod, across the cutting plane"},
    {.name = "x_axis",
     .kind = KEY_VECTOR,
     .count = 3,
     .initial = "[1, 0, 0]",
     .offset = offsetof(step_spec, x_axis),
     .about = "direction of the section's x"},
};

static const step_spec step_initial = {.normal = {0, 0, 1}, .x_axis = {1, 0, 0}};

const key_table step_keys = {.name = "step",
                             .size = sizeof(step_spec),
                             .nkey = COUNT(step_key_list),
                             .keys = step_key_list,
                             .initial = &step_initial,
                             .about = "bodies of a STEP file, cut at a plane"};

static const key dxf_key_list[] = {
    FILE_KEY(dxf_spec, "an ASCII DXF file"),
    PARTS_KEY(dxf_spec),
    {.name = "unit",
     .kind = KEY_CHOICE,
     .choices = "file|mm|m|cm|um|in",
     .initial = "file",
     .offset = offsetof(dxf_spec, unit),
     .about = "of the lengths in the file; file: what its header says ($INSUNITS), else mm"},
};

const key_table dxf_keys = {.name = "dxf",
                            .size = sizeof(dxf_spec),
                            .nkey = COUNT(dxf_key_list),
                            .keys = dxf_key_list,
                            .about = "a drawing, its layers the materials"};

static const key geo_key_list[] = {FILE_KEY(geo_spec, "a gmsh script"), PARTS_KEY(geo_spec),
                                   UNIT_KEY(geo_spec)};

const key_table geo_keys = {.name = "geo",
                            .size = sizeof(geo_spec),
                            .nkey = COUNT(geo_key_list),
                            .keys = geo_key_list,
                            .about = "a gmsh script; it may run programs, so only with "
                                     "--allow-scripts"};
