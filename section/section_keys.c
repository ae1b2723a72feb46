// section/section_keys.c
#include "section/section.h"

#include "base/nearest.h"

#include <math.h>
#include <string.h>

enum { MOST_STATIONS = 1000, MOST_SHAPES = 500, MOST_POINTS = 100, MOST_WRENCHES = 100 };

// about the digits that tables print
#define DEFAULT_AGREEMENT 1e-3

static const key reference_list[] = {
    {.name = "source",
     .kind = KEY_TEXT,
     .offset = offsetof(section_reference, source),
     .about = "where the numbers stand"},
    {.name = "tolerance",
     .kind = KEY_REAL,
     .min = 1e-14,
     .max = 1,
     .initial = "1e-3",
     .offset = offsetof(section_reference, tolerance),
     .about = "largest difference of an entry, relative to sqrt(K_ii K_jj)"},
    {.name = "K",
     .kind = KEY_ROWS,
     .count = 3,
     .max_count = 36,
     .required = true,
     .offset = offsetof(section_reference, K),
     .about = "entries of the 6x6 as [row, column, value]: rows and columns from 1 in the order nx "
              "ny nz mx my mz, values in N, N m and N m^2"},
};

static const section_reference initial_reference = {.tolerance = DEFAULT_AGREEMENT};

static const key_table reference_keys = {
    .name = "reference",
    .size = sizeof(section_reference),
    .nkey = sizeof reference_list / sizeof *reference_list,
    .keys = reference_list,
    .initial = &initial_reference,
    .about = "a published 6x6 that `compare` holds the section to",
};

#define FILE_KEY(word, words)                                                                      \
    {                                                                                              \
        .name = #word, .kind = KEY_TABLE, .one_of = 1,                                             \
        .offset = offsetof(section_case, files.word), .table = &word##_keys, .about = words        \
    }

static const key keys[] = {
    {.name = "model",
     .kind = KEY_CHOICE,
     .choices = "full|classical",
     .initial = "full",
     .offset = offsetof(section_case, model),
     .about =
         "full: with warping, any shape; classical: E- and G-weighted integrals, Eq. 11 and 12 "
         "of the paper"},
    {.name = "shapes",
     .kind = KEY_LIST,
     .one_of = 1,
     .max_count = MOST_SHAPES,
     .offset = offsetof(section_case, shapes),
     .table = &shape_keys,
     .about = "what the section is made of; a later shape lies on top of the earlier ones"},
    FILE_KEY(png, "an image or a stack of them, one colour one material"),
    FILE_KEY(msh, "a gmsh mesh, its physical groups the materials"),
    FILE_KEY(step, "bodies of a STEP file, cut at a plane"),
    FILE_KEY(dxf, "a drawing, its layers the materials"),
    FILE_KEY(geo, "a gmsh script; only with --allow-scripts"),
    {.name = "turn",
     .kind = KEY_FIELD,
     .dimension = DIM_ANGLE,
     .initial = "0",
     .offset = offsetof(section_case, turn),
     .about = "turn of the whole section about its origin"},
    {.name = "scale",
     .kind = KEY_FIELD,
     .min = 1e-6,
     .max = 1e6,
     .initial = "1",
     .offset = offsetof(section_case, scale),
     .about = "scale of all lengths of the section about its origin"},
    {.name = "pattern_turn",
     .kind = KEY_FIELD,
     .dimension = DIM_ANGLE,
     .initial = "0",
     .offset = offsetof(section_case, pattern_turn),
     .about = "how the pattern in a stack of slices turns along s: its rate couples stretch and "
              "twist; the slices themselves stay as they are"},
    {.name = "mesh",
     .kind = KEY_TABLE,
     .offset = offsetof(section_case, mesh),
     .table = &mesh_keys,
     .about = "how the section is divided into elements"},
    {.name = "stations",
     .kind = KEY_ROWS,
     .dimension = DIM_LENGTH,
     .max_count = MOST_STATIONS,
     .offset = offsetof(section_case, stations),
     .about = "arclengths to report, [0, 60, 120]; without them they are chosen by how the section "
              "varies"},
    {.name = "points",
     .kind = KEY_ROWS,
     .dimension = DIM_LENGTH,
     .count = 2,
     .max_count = MOST_POINTS,
     .offset = offsetof(section_case, points),
     .about = "[[x, y], ...] about which the stiffness is reported too, in the body's axes"},
    {.name = "wrenches",
     .kind = KEY_LIST,
     .max_count = MOST_WRENCHES,
     .offset = offsetof(section_case, wrenches),
     .table = &section_wrench_keys,
     .about = "wrenches under which strains and stresses are asked for"},
    {.name = "tolerance",
     .kind = KEY_REAL,
     .min = 1e-14,
     .max = 1e-2,
     .offset = offsetof(section_case, tolerance),
     .about =
         "relative error of the stiffness that the mesh is chosen for, unless it has a size, "
         "and between the stations along the rod; without it the mesh is a fixed one, and 1e-10 "
         "holds along the rod as far as the sections' own errors allow"},
    {.name = "reference",
     .kind = KEY_TABLE,
     .offset = offsetof(section_case, reference),
     .table = &reference_keys,
     .about = "a published 6x6 that `compare` holds the section to"},
};

static const section_case initial = {
    .model = MODEL_FULL,
    .scale = {.value = 1},
    .mesh = {.kind = MESH_AUTO},
    .files = {.step = {.normal = {0, 0, 1}, .x_axis = {1, 0, 0}}}, // as in step_keys
    .reference = {.tolerance = DEFAULT_AGREEMENT},
};

const key_table section_keys = {
    .name = "section",
    .size = sizeof(section_case),
    .nkey = sizeof keys / sizeof *keys,
    .keys = keys,
    .initial = &initial,
    .about = "the cross section",
};

section_case section_case_default(void)
{
    section_case c = initial;
    c.mesh = mesh_options_default();
    return c;
}

// --- materials by name

static int find_material(const key_list *materials, const char *name)
{
    const material *m = materials->items;
    for (int i = 0; i < materials->count; i++) {
        if (strcmp(m[i].name, name) == 0) {
            return i;
        }
    }
    return -1;
}

static status unknown_material(const key_list *materials, const char *name)
{
    const material *m = materials->items;
    nearest near = nearest_to(name);
    char words[NEAREST_WORDS];
    nearest_offer(&near, "none", "none");
    for (int i = 0; i < materials->count; i++) {
        nearest_offer(&near, m[i].name, m[i].name);
    }
    return status_fail(ERR_INPUT, "material '%s' is not defined%s", name,
                       nearest_words(&near, words));
}

static status bind_shapes(section_case *c, const key_list *materials, mark *where)
{
    shape_spec *shapes = c->shapes.items;
    bool any = false;
    for (int i = 0; i < c->shapes.count; i++) {
        const char *name = shapes[i].material.text;
        *where = name ? shapes[i].material.at : shapes[i].at;
        if (!name && !mark_given(shapes[i].lumens.at)) {
            return status_fail(ERR_INPUT, "key 'material' is missing in this entry of 'shapes'");
        }
        name = name ? name : "none";
        const bool cuts = strcmp(name, "none") == 0;
        shapes[i].material_index = cuts ? -1 : find_material(materials, name);
        if (!cuts && shapes[i].material_index < 0) {
            return unknown_material(materials, name);
        }
        any = any || !cuts;
    }
    *where = c->shapes.at;
    return any ? OK : status_fail(ERR_INPUT, "no shape of the section has a material");
}

static status check_reference(const section_reference *reference, mark *where)
{
    for (int k = 0; k < reference->K.nrow; k++) {
        const double *row = reference->K.a + (size_t)3 * (size_t)k;
        for (int i = 0; i < 2; i++) {
            if (!(row[i] >= 1 && row[i] <= 6) || row[i] != (int)row[i]) {
                *where = reference->K.at;
                return status_fail(ERR_INPUT,
                                   "entry %d of reference.K: %g is no row or column of a 6x6; they "
                                   "count from 1 to 6",
                                   k + 1, row[i]);
            }
        }
        if (!isfinite(row[2])) {
            *where = reference->K.at;
            return status_fail(ERR_INPUT, "entry %d of reference.K is not a number", k + 1);
        }
    }
    return OK;
}

status section_case_bind(section_case *c, const key_list *materials,
                         const section_surroundings *around, mark *where)
{
    const drawing_request request = {
        .directory = around->directory,
        .allow_scripts = around->allow_scripts,
        .nmaterial = materials->count,
        .materials = materials->items,
    };
    status st = OK;
    TRY(check_reference(&c->reference, where));
    *where = c->at;
    mesh_options_resolve(&c->mesh);
    c->nmaterial = materials->count;
    TRY(drawing_open(&c->files, &request, &c->drawing));
    if (!c->drawing) {
        TRY(bind_shapes(c, materials, where));
    } else if (c->mesh.order_chosen && drawing_best_order(c->drawing) > 0) {
        c->mesh.order = drawing_best_order(c->drawing);
    }

done:
    return st;
}

void section_case_release(section_case *c)
{
    drawing_free(c->drawing);
    c->drawing = NULL;
}
