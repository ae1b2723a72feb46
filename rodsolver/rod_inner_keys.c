// rodsolver/rod_inner_keys.c
// Tendons, base and rest shape as a case writes them.
#include "rodsolver/rod_inner_keys.h"

#define COUNT(list) ((int)(sizeof(list) / sizeof *(list)))

// far beyond any robot; what is larger is a mistake in the unit
#define MOST_METRES 1e3
#define MOST_CURVATURE 1e6

#define PLACE(word, dim, member, text)                                                             \
    {                                                                                              \
        .name = word, .kind = KEY_FIELD, .dimension = dim,                                         \
        .offset = offsetof(tendon_case, spec.member), .initial = "0", .about = text                \
    }
#define AMOUNT(word, dim, least, most, member, text, standard)                                     \
    {                                                                                              \
        .name = word, .kind = KEY_REAL, .dimension = dim, .min = least, .max = most,               \
        .offset = offsetof(tendon_case, spec.member), .initial = standard, .about = text           \
    }

static const key tendon_list[] = {
    {.name = "name",
     .kind = KEY_TEXT,
     .offset = offsetof(tendon_case, spec.name),
     .about = "what messages, sweeps and reports call it"},
    PLACE("radius", DIM_LENGTH, radius, "distance from the geometric centre; may vary along s"),
    PLACE("angle", DIM_ANGLE, angle, "from +x towards +y; may vary along s"),
    PLACE("x", DIM_LENGTH, x, "added to the polar place; may vary along s"),
    PLACE("y", DIM_LENGTH, y, "added to the polar place; may vary along s"),
    {.name = "path",
     .kind = KEY_ROWS,
     .dimension = DIM_LENGTH,
     .count = 3,
     .max_count = 100000,
     .one_of = -1,
     .offset = offsetof(tendon_case, path),
     .about =
         "a table of rows [s, x, y] from the base to the tendon's end, added to the place too"},
    {.name = "path_csv",
     .kind = KEY_NAME,
     .one_of = -1,
     .offset = offsetof(tendon_case, path_csv),
     .about = "the same table in a file: a line of names with units (s_mm, x_mm, y_mm), then rows; "
              "from the case's folder"},
    AMOUNT("smooth", DIM_LENGTH, 0, 1, table.smooth,
           "rms distance from the table's points that a smooth fit may leave; 0: through them",
           "0"),
    AMOUNT("end", DIM_LENGTH, 1e-9, MOST_METRES, end, "arclength where the tendon is anchored",
           "the tip"),
    AMOUNT("friction", DIM_NONE, 0, 10, friction, "coefficient along its path, while being pulled",
           "0"),
    AMOUNT("EA", DIM_FORCE, 1e-9, 1e12, EA, "the tendon's own axial stiffness",
           "it does not stretch"),
    AMOUNT("outside", DIM_LENGTH, 0, MOST_METRES, outside,
           "its length between actuator and base, which stretches too", "0"),
};

const key_table rod_tendon_keys = {
    .name = "tendon",
    .size = sizeof(tendon_case),
    .nkey = COUNT(tendon_list),
    .keys = tendon_list,
    .about = "a tendon from the base to its end",
};

static const key base_list[] = {
    {.name = "position",
     .kind = KEY_VECTOR,
     .dimension = DIM_LENGTH,
     .min = -MOST_METRES,
     .max = MOST_METRES,
     .count = 3,
     .offset = offsetof(base_case, position),
     .initial = "[0, 0, 0]",
     .about = "of the base's geometric centre"},
    {.name = "rotation",
     .kind = KEY_VECTOR,
     .dimension = DIM_ANGLE,
     .min = -1e3,
     .max = 1e3,
     .count = 3,
     .offset = offsetof(base_case, rotation),
     .initial = "[0, 0, 0]",
     .about = "rotation vector: its direction is the axis, its length the angle"},
    {.name = "insertion",
     .kind = KEY_REAL,
     .dimension = DIM_LENGTH,
     .min = -MOST_METRES,
     .max = MOST_METRES,
     .offset = offsetof(base_case, insertion),
     .initial = "0",
     .about = "how far the base is pushed along its own axis, after position and rotation"},
    {.name = "turn",
     .kind = KEY_REAL,
     .dimension = DIM_ANGLE,
     .min = -1e3,
     .max = 1e3,
     .offset = offsetof(base_case, turn),
     .initial = "0",
     .about = "how far it is turned about its own axis"},
};

const key_table rod_base_keys = {
    .name = "base",
    .size = sizeof(base_case),
    .nkey = COUNT(base_list),
    .keys = base_list,
    .about = "where the rod is clamped; left out, the base stands at the origin and looks along z",
};

#define REST(word, member, text)                                                                   \
    {                                                                                              \
        .name = word, .kind = KEY_FIELD, .dimension = DIM_CURVATURE, .min = -MOST_CURVATURE,       \
        .max = MOST_CURVATURE, .offset = offsetof(rest_shape, member), .initial = "0",             \
        .about = text                                                                              \
    }

static const key rest_list[] = {
    REST("curvature_x", curvature_x, "about the section's x; may vary along s (in metres)"),
    REST("curvature_y", curvature_y, "about the section's y; may vary along s (in metres)"),
    REST("twist", twist, "about the tangent; may vary along s (in metres)"),
};

const key_table rod_rest_keys = {
    .name = "rest",
    .size = sizeof(rest_shape),
    .nkey = COUNT(rest_list),
    .keys = rest_list,
    .about =
        "the shape at rest: curvature and twist of the geometric centreline, in the body frame",
};
