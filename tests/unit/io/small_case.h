// tests/unit/io/small_case.h
// Key tables with every kind of key, in the form of a real case.
#pragma once

#include "base/key.h"
#include "io/config.h"

#include <math.h>

#define SMALL_COUNT(a) ((int)(sizeof(a) / sizeof *(a)))

typedef struct small_ring {
    mark at;
    field outer, inner, mid_angle, width;
} small_ring;

typedef struct small_shape {
    mark at;
    small_ring annulus, sector;
    key_text material;
} small_shape;

typedef struct small_material {
    mark at;
    const char *name;
    double E, nu;
} small_material;

typedef struct small_section {
    mark at;
    int model;
    key_list shapes;
    key_rows points;
} small_section;

typedef struct small_tendon {
    mark at;
    const char *name;
    field radius, angle;
    double end;
} small_tendon;

typedef struct small_rod {
    mark at;
    double length;
    key_list tendons;
    key_rows tensions;
    int points;
    bool pictures;
    double tolerance;
} small_rod;

typedef struct small_load {
    mark at;
    const char *name;
    double force[3];
    key_rows point;
    int at_kind;
} small_load;

typedef struct small_case {
    mark at;
    int format;
    const char *title;
    key_list materials;
    small_section section;
    small_rod rod;
    key_list loads;
} small_case;

#define SMALL_RING(field_name, text, unit_kind, low, high, needed)                                 \
    {                                                                                              \
        .name = text, .kind = KEY_FIELD, .dimension = unit_kind, .min = low, .max = high,          \
        .required = needed, .offset = offsetof(small_ring, field_name), .about = "of the ring"     \
    }

static const key small_ring_list[] = {
    SMALL_RING(outer, "outer_radius", DIM_LENGTH, 1e-6, 1, true),
    SMALL_RING(inner, "inner_radius", DIM_LENGTH, 0, 1, true),
    SMALL_RING(mid_angle, "mid_angle", DIM_ANGLE, -100, 100, false),
    SMALL_RING(width, "width", DIM_ANGLE, 1e-6, 6.283185307179586, false),
};
static const key_table small_ring_keys = {
    "ring", sizeof(small_ring),       SMALL_COUNT(small_ring_list), small_ring_list,
    NULL,   "a ring or a part of one"};

static const key small_shape_list[] = {
    {.name = "annulus",
     .kind = KEY_TABLE,
     .one_of = 1,
     .offset = offsetof(small_shape, annulus),
     .table = &small_ring_keys,
     .about = "a full ring"},
    {.name = "sector",
     .kind = KEY_TABLE,
     .one_of = 1,
     .offset = offsetof(small_shape, sector),
     .table = &small_ring_keys,
     .about = "a part of a ring"},
    {.name = "material",
     .kind = KEY_NAME,
     .required = true,
     .offset = offsetof(small_shape, material),
     .about = "a name under materials"},
};
static const key_table small_shape_keys = {
    "shape", sizeof(small_shape), SMALL_COUNT(small_shape_list), small_shape_list,
    NULL,    "one shape"};

static const key small_material_list[] = {
    {.name = "E",
     .kind = KEY_REAL,
     .dimension = DIM_STRESS,
     .min = 1e-3,
     .max = 1e16,
     .required = true,
     .offset = offsetof(small_material, E),
     .about = "Young's modulus"},
    {.name = "nu",
     .kind = KEY_REAL,
     .min = -0.999,
     .max = 0.4999,
     .required = true,
     .offset = offsetof(small_material, nu),
     .about = "Poisson's ratio"},
};
static const key_table small_material_keys = {
    "material", sizeof(small_material),     SMALL_COUNT(small_material_list), small_material_list,
    NULL,       "a linear elastic material"};

static const key small_section_list[] = {
    {.name = "model",
     .kind = KEY_CHOICE,
     .choices = "full|classical",
     .initial = "full",
     .offset = offsetof(small_section, model),
     .about = "with or without warping"},
    {.name = "shapes",
     .kind = KEY_LIST,
     .required = true,
     .max_count = 1000,
     .offset = offsetof(small_section, shapes),
     .table = &small_shape_keys,
     .about = "laid on one another"},
    {.name = "points",
     .kind = KEY_ROWS,
     .dimension = DIM_LENGTH,
     .count = 2,
     .max_count = 4,
     .offset = offsetof(small_section, points),
     .about = "marked points"},
};
static const key_table small_section_keys = {
    "section", sizeof(small_section), SMALL_COUNT(small_section_list), small_section_list,
    NULL,      "the cross section"};

static const key small_tendon_list[] = {
    {.name = "name",
     .kind = KEY_TEXT,
     .offset = offsetof(small_tendon, name),
     .about = "for tables"},
    {.name = "radius",
     .kind = KEY_FIELD,
     .dimension = DIM_LENGTH,
     .max = 1,
     .offset = offsetof(small_tendon, radius),
     .about = "from the axis"},
    {.name = "angle",
     .kind = KEY_FIELD,
     .dimension = DIM_ANGLE,
     .offset = offsetof(small_tendon, angle),
     .about = "from x"},
    {.name = "end",
     .kind = KEY_REAL,
     .dimension = DIM_LENGTH,
     .max = 10,
     .offset = offsetof(small_tendon, end),
     .about = "where it is anchored"},
};
static const key_table small_tendon_keys = {
    "tendon", sizeof(small_tendon), SMALL_COUNT(small_tendon_list), small_tendon_list,
    NULL,     "one tendon"};

static const key small_rod_list[] = {
    {.name = "length",
     .kind = KEY_REAL,
     .dimension = DIM_LENGTH,
     .min = 1e-6,
     .max = 10,
     .required = true,
     .offset = offsetof(small_rod, length),
     .about = "of the rod"},
    {.name = "tendons",
     .kind = KEY_LIST,
     .offset = offsetof(small_rod, tendons),
     .table = &small_tendon_keys,
     .about = "the tendons"},
    {.name = "tensions",
     .kind = KEY_ROWS,
     .dimension = DIM_FORCE,
     .max = INFINITY,
     .offset = offsetof(small_rod, tensions),
     .about = "one row for each solution"},
    {.name = "points",
     .kind = KEY_INTEGER,
     .min = 2,
     .max = 100000,
     .initial = "101",
     .offset = offsetof(small_rod, points),
     .about = "of the shape"},
    {.name = "pictures",
     .kind = KEY_FLAG,
     .initial = "true",
     .offset = offsetof(small_rod, pictures),
     .about = "drawn | or not"},
    {.name = "tolerance",
     .kind = KEY_REAL,
     .min = 1e-14,
     .max = 1e-2,
     .initial = "1e-6",
     .offset = offsetof(small_rod, tolerance),
     .about = "of the tip"},
};
static const key_table small_rod_keys = {
    "rod",
    sizeof(small_rod),
    SMALL_COUNT(small_rod_list),
    small_rod_list,
    &(const small_rod){.points = 101, .pictures = true, .tolerance = 1e-6},
    "the rod"};

static const key small_load_list[] = {
    {.name = "name", .kind = KEY_TEXT, .offset = offsetof(small_load, name), .about = "for tables"},
    {.name = "force",
     .kind = KEY_VECTOR,
     .dimension = DIM_FORCE,
     .count = 3,
     .initial = "[0, 0, 0]",
     .offset = offsetof(small_load, force),
     .about = "on the tip"},
    {.name = "at",
     .kind = KEY_ROWS,
     .dimension = DIM_LENGTH,
     .count = 2,
     .max_count = 1,
     .one_of = -1,
     .offset = offsetof(small_load, point),
     .about = "where it acts"},
    {.name = "at",
     .kind = KEY_CHOICE,
     .choices = "geometric_centre|stiffness_centre",
     .one_of = -1,
     .offset = offsetof(small_load, at_kind),
     .about = "where it acts"},
};
static const key_table small_load_keys = {
    "load", sizeof(small_load), SMALL_COUNT(small_load_list), small_load_list, NULL, "one load"};

static const key small_case_list[] = {
    {.name = "format",
     .kind = KEY_INTEGER,
     .min = 1,
     .max = 1,
     .required = true,
     .offset = offsetof(small_case, format),
     .about = "of this file"},
    {.name = "title",
     .kind = KEY_TEXT,
     .offset = offsetof(small_case, title),
     .about = "for the report"},
    {.name = "materials",
     .kind = KEY_NAMED,
     .required = true,
     .offset = offsetof(small_case, materials),
     .table = &small_material_keys,
     .about = "by name"},
    {.name = "section",
     .kind = KEY_TABLE,
     .offset = offsetof(small_case, section),
     .table = &small_section_keys,
     .about = "the cross section"},
    {.name = "rod",
     .kind = KEY_TABLE,
     .offset = offsetof(small_case, rod),
     .table = &small_rod_keys,
     .about = "the rod"},
    {.name = "loads",
     .kind = KEY_LIST,
     .offset = offsetof(small_case, loads),
     .table = &small_load_keys,
     .about = "the loads"},
};
static const key_table small_case_keys = {
    "case", sizeof(small_case), SMALL_COUNT(small_case_list), small_case_list,
    NULL,   "a whole case"};

// a case without a mistake; one line each, so that a test can count
static const char small_text[] =
    "format: 1\n"                                                                   // 1
    "title: constant-offset prototype\n"                                            // 2
    "materials:\n"                                                                  // 3
    "  soft:  {E_MPa: 0.66,  nu: 0.3}\n"                                            // 4
    "  stiff: {E_MPa: 15.93, nu: 0.3}\n"                                            // 5
    "section:\n"                                                                    // 6
    "  model: classical   # the paper's\n"                                          // 7
    "  shapes:\n"                                                                   // 8
    "    - {annulus: {outer_radius_mm: 4, inner_radius_mm: 3.2}, material: soft}\n" // 9
    "    - sector:\n"                                                               // 10
    "        outer_radius_mm: 4\n"                                                  // 11
    "        inner_radius_mm: 3.2\n"                                                // 12
    "        mid_angle_rad: pi*s/L\n"                                               // 13
    "        width_rad: pi/4 - (pi/8)*(s/L)\n"                                      // 14
    "      material: stiff\n"                                                       // 15
    "rod:\n"                                                                        // 16
    "  length_mm: 120\n"                                                            // 17
    "  tendons:\n"                                                                  // 18
    "    - {name: t1, radius_mm: 3.6, angle_rad: 0}\n"                              // 19
    "    - {name: t2, radius_mm: 3 + s/200, angle_deg: 180, end_mm: L/2}\n"         // 20
    "  tensions_N: [[0.49, 0], [0.67, 0], [0, 0.98]]\n"                             // 21
    "loads:\n"                                                                      // 22
    "  - {name: geometric centre, force_N: [0, 0, -0.5], at_mm: [0, 1]}\n"          // 23
    "  - {name: stiffness centre, force_N: [0, 0, -1/2], at: stiffness_centre}\n";  // 24
