// base/material_keys.c
#include "base/material.h"

#include <math.h>

#define MODULUS_KEY(word, words)                                                                   \
    {                                                                                              \
        .name = #word, .kind = KEY_REAL, .dimension = DIM_STRESS,                                  \
        .min = MATERIAL_SMALLEST_MODULUS, .max = MATERIAL_LARGEST_MODULUS,                         \
        .offset = offsetof(material, word), .about = words                                         \
    }

#define RATIO_KEY(word, words)                                                                     \
    {                                                                                              \
        .name = #word, .kind = KEY_REAL, .offset = offsetof(material, word), .about = words        \
    }

#define ANGLE_KEY(word, words)                                                                     \
    {                                                                                              \
        .name = #word, .kind = KEY_REAL, .dimension = DIM_ANGLE, .initial = "0",                   \
        .offset = offsetof(material, word), .about = words                                         \
    }

// the ways to give the elastic constants exclude each other
enum { GROUP_ELASTIC = 1, MOST_ROWS = 6 };

static const key table_key_list[] = {
    {.name = "along",
     .kind = KEY_CHOICE,
     .choices = "x|y|s",
     .required = true,
     .offset = offsetof(field_table, along),
     .about = "what it runs over: a coordinate of the section or the arclength"},
    {.name = "at",
     .kind = KEY_ROWS,
     .dimension = DIM_LENGTH,
     .required = true,
     .offset = offsetof(field_table, places),
     .about = "places, ascending; beyond the ends the modulus stays what it is there"},
    {.name = "E",
     .kind = KEY_ROWS,
     .dimension = DIM_STRESS,
     .min = MATERIAL_SMALLEST_MODULUS,
     .max = MATERIAL_LARGEST_MODULUS,
     .required = true,
     .offset = offsetof(field_table, values),
     .about = "Young's modulus at each of them; a monotone cubic in between"},
};

static const key_table table_keys = {
    .name = "modulus_table",
    .size = sizeof(field_table),
    .nkey = sizeof table_key_list / sizeof *table_key_list,
    .keys = table_key_list,
    .about = "Young's modulus over one coordinate",
};

static const key keys[] = {
    {.name = "E",
     .kind = KEY_PLACE,
     .dimension = DIM_STRESS,
     .min = MATERIAL_SMALLEST_MODULUS,
     .max = MATERIAL_LARGEST_MODULUS,
     .one_of = GROUP_ELASTIC,
     .offset = offsetof(material, modulus),
     .about = "isotropic: Young's modulus"},
    {.name = "E_table",
     .kind = KEY_TABLE,
     .one_of = GROUP_ELASTIC,
     .offset = offsetof(material, table),
     .table = &table_keys,
     .about = "isotropic: Young's modulus by a table over x, y or s"},
    RATIO_KEY(nu, "isotropic: Poisson's ratio, -1 < nu < 0.5"),
    {.name = "E1",
     .kind = KEY_REAL,
     .dimension = DIM_STRESS,
     .min = MATERIAL_SMALLEST_MODULUS,
     .max = MATERIAL_LARGEST_MODULUS,
     .one_of = GROUP_ELASTIC,
     .offset = offsetof(material, E1),
     .about = "orthotropic: Young's modulus along the own axis 1, the fibre; with E2, E3, G12, "
              "G13, G23, nu12, nu13 and nu23"},
    MODULUS_KEY(E2, "orthotropic: Young's modulus along the own axis 2"),
    MODULUS_KEY(E3, "orthotropic: Young's modulus along the own axis 3"),
    MODULUS_KEY(G12, "orthotropic: shear modulus in the own plane 12"),
    MODULUS_KEY(G13, "orthotropic: shear modulus in the own plane 13"),
    MODULUS_KEY(G23, "orthotropic: shear modulus in the own plane 23"),
    RATIO_KEY(nu12, "orthotropic: -eps_2 / eps_1 under tension along 1; nu12^2 < E1/E2"),
    RATIO_KEY(nu13, "orthotropic: -eps_3 / eps_1 under tension along 1; nu13^2 < E1/E3"),
    RATIO_KEY(nu23, "orthotropic: -eps_3 / eps_2 under tension along 2; nu23^2 < E2/E3"),
    {.name = "stiffness",
     .kind = KEY_ROWS,
     .dimension = DIM_STRESS,
     .count = 6,
     .max_count = MOST_ROWS,
     .one_of = GROUP_ELASTIC,
     .offset = offsetof(material, stiffness),
     .about = "anisotropic: six rows of the stiffness in own axes, order 11 22 33 23 13 12 with "
              "engineering shear strains; symmetric, positive definite"},
    ANGLE_KEY(fibre_angle, "turn of the own axes 1 and 2 about 3, from 1 towards 2, after "
                           "plane_angle"),
    ANGLE_KEY(plane_angle, "turn of the own axes 2 and 3 about 1, from 2 towards 3; unturned, 1 "
                           "is z, 2 is x and 3 is y, or what the shape says"),
    {.name = "density",
     .kind = KEY_REAL,
     .dimension = DIM_DENSITY,
     .min = 1e-6,
     .max = 1e9,
     .offset = offsetof(material, density),
     .about = "mass over volume"},
    {.name = "linear_strain",
     .kind = KEY_REAL,
     .min = 1e-9,
     .max = 10,
     .offset = offsetof(material, linear_strain),
     .about =
         "largest strain at which the material stays close to linear; larger ones are pointed out"},
};

// NaN: not given, which 0 would not tell of a Poisson's ratio
static const material initial = {
    .nu = NAN,
    .nu12 = NAN,
    .nu13 = NAN,
    .nu23 = NAN,
};

const key_table material_keys = {
    .name = "material",
    .size = sizeof(material),
    .nkey = sizeof keys / sizeof *keys,
    .keys = keys,
    .initial = &initial,
    .about = "a linear elastic material: isotropic (E, nu), orthotropic (E1, E2, ...) or "
             "anisotropic (stiffness)",
};
