// fem/segment_load_keys.c
// Loads, springs and held faces of the 3D segment as a case writes them.
#include "fem/segment_inner_keys.h"

#include <math.h>

#define COUNT(list) ((int)(sizeof(list) / sizeof *(list)))

// what acts is far below: such a number is a mistake in the unit
#define MOST_METRES 1e3
#define MOST_PASCAL 1e12
#define MOST_VOLUME_FORCE 1e15
#define MOST_ACCELERATION 1e6
#define MOST_STIFFNESS 1e18

// as segment_face_part reads them
#define FACES                                                                                      \
    "base|tip|outside|inside|hole_1|hole_2|hole_3|hole_4|hole_5|hole_6|hole_7|hole_8|hole_9|"      \
    "hole_10|hole_11|hole_12|hole_13|hole_14|hole_15|hole_16"
#define FACE_ABOUT                                                                                 \
    "an end, the wall that nothing surrounds, the walls of all holes, or of one: hole_1 is the "   \
    "largest"

// where on the body, at the head of a table
#define PART_OF(struct_, does)                                                                     \
    {.name = "face",                                                                               \
     .kind = KEY_CHOICE,                                                                           \
     .choices = FACES,                                                                             \
     .required = true,                                                                             \
     .offset = offsetof(struct_, face),                                                            \
     .about = FACE_ABOUT},                                                                         \
        {.name = "from",                                                                           \
         .kind = KEY_REAL,                                                                         \
         .dimension = DIM_LENGTH,                                                                  \
         .min = 0,                                                                                 \
         .max = MOST_METRES,                                                                       \
         .offset = offsetof(struct_, range[0]),                                                    \
         .initial = "0",                                                                           \
         .about = "height above the base where it begins to " does ", on walls"},                  \
    {                                                                                              \
        .name = "to", .kind = KEY_REAL, .dimension = DIM_LENGTH, .min = 0, .max = MOST_METRES,     \
        .offset = offsetof(struct_, range[1]), .initial = "the tip",                               \
        .about = "height where it ceases to " does                                                 \
    }

#define VECTOR(word, dim, most, struct_, member, text)                                             \
    {                                                                                              \
        .name = word, .kind = KEY_VECTOR, .dimension = dim, .min = -(most), .max = most,           \
        .count = 3, .offset = offsetof(struct_, member), .initial = "[0, 0, 0]", .about = text     \
    }

static const key pressure_list[] = {
    PART_OF(segment_pressure, "act"),
    {.name = "pressure",
     .kind = KEY_REAL,
     .dimension = DIM_STRESS,
     .min = -MOST_PASCAL,
     .max = MOST_PASCAL,
     .one_of = 1,
     .offset = offsetof(segment_pressure, pressure),
     .about = "presses against the face; below zero it pulls"},
    {.name = "traction",
     .kind = KEY_VECTOR,
     .dimension = DIM_STRESS,
     .min = -MOST_PASCAL,
     .max = MOST_PASCAL,
     .count = 3,
     .one_of = 1,
     .offset = offsetof(segment_pressure, traction),
     .about = "force per area along x, y, z of the base"},
};

static const segment_pressure whole_pressure = {.range = {0, INFINITY}};

static const key_table pressure_keys = {
    .name = "segment_pressure",
    .size = sizeof(segment_pressure),
    .nkey = COUNT(pressure_list),
    .keys = pressure_list,
    .initial = &whole_pressure,
    .about = "a pressure or a traction on a face of the 3D segment",
};

#define OPEN_ROW(word, dim, most, struct_, member, text)                                           \
    {                                                                                              \
        .name = word, .kind = KEY_ROWS, .dimension = dim, .min = -(most), .max = most, .count = 3, \
        .max_count = 1, .open = true, .offset = offsetof(struct_, member), .about = text           \
    }

static const key motion_list[] = {
    OPEN_ROW("translation", DIM_LENGTH, MOST_METRES, segment_motion, translation,
             "of the tip's geometric centre along x, y, z; ~ leaves a direction free"),
    OPEN_ROW("rotation", DIM_ANGLE, 1e3, segment_motion, rotation,
             "of the tip about x, y, z; ~ leaves a direction free"),
};

static const key_table motion_keys = {
    .name = "segment_motion",
    .size = sizeof(segment_motion),
    .nkey = COUNT(motion_list),
    .keys = motion_list,
    .about = "a motion that is imposed on the tip",
};

static const key load_list[] = {
    {.name = "name",
     .kind = KEY_TEXT,
     .required = true,
     .offset = offsetof(segment_load, name),
     .about = "what the load is called in tables and pictures"},
    {.name = "force",
     .kind = KEY_VECTOR,
     .dimension = DIM_FORCE,
     .count = 3,
     .offset = offsetof(segment_load, force),
     .initial = "[0, 0, 0]",
     .about = "force on the tip, along x, y, z; a negative third component compresses"},
    {.name = "moment",
     .kind = KEY_VECTOR,
     .dimension = DIM_MOMENT,
     .count = 3,
     .offset = offsetof(segment_load, moment),
     .initial = "[0, 0, 0]",
     .about = "moment on the tip about the point where the force acts"},
    {.name = "at",
     .kind = KEY_CHOICE,
     .choices = "geometric_centre|stiffness_centre",
     .one_of = -1,
     .offset = offsetof(segment_load, at_kind),
     .initial = "geometric_centre",
     .about = "where the force acts; the stiffness centre is the section analysis' own"},
    {.name = "at",
     .kind = KEY_ROWS,
     .dimension = DIM_LENGTH,
     .count = 2,
     .max_count = 1,
     .one_of = -1,
     .offset = offsetof(segment_load, point),
     .about = "[x, y] where the force acts"},
    {.name = "pressures",
     .kind = KEY_LIST,
     .max_count = 256,
     .offset = offsetof(segment_load, pressures),
     .table = &pressure_keys,
     .about = "pressures and tractions on faces"},
    VECTOR("body_force", DIM_FORCE_PER_VOLUME, MOST_VOLUME_FORCE, segment_load, body_force,
           "force per volume, along x, y, z"),
    VECTOR("acceleration", DIM_ACCELERATION, MOST_ACCELERATION, segment_load, acceleration,
           "of gravity, along x, y, z; needs a density of every material"),
    {.name = "tip_motion",
     .kind = KEY_TABLE,
     .offset = offsetof(segment_load, tip_motion),
     .table = &motion_keys,
     .about = "imposed on the tip; what it leaves free carries the load's force and moment"},
    {.name = "move_holds",
     .kind = KEY_FLAG,
     .offset = offsetof(segment_load, holds_move),
     .initial = "false",
     .about = "the held faces move by their `motion`; in other loads they stay where they are"},
};

static const segment_load load_initial = {.at_kind = -1};

const key_table segment_load_keys = {
    .name = "segment_load",
    .size = sizeof(segment_load),
    .nkey = COUNT(load_list),
    .keys = load_list,
    .initial = &load_initial,
    .about = "one load on the 3D segment: everything in it acts together",
};

#define STIFFNESS(word, member, text)                                                              \
    {                                                                                              \
        .name = word, .kind = KEY_REAL, .dimension = DIM_FORCE_PER_VOLUME, .min = 0,               \
        .max = MOST_STIFFNESS, .offset = offsetof(segment_spring, member), .initial = "0",         \
        .about = text                                                                              \
    }

static const key spring_list[] = {
    PART_OF(segment_spring, "act"),
    STIFFNESS("normal", normal, "force per area and displacement along the face's normal"),
    STIFFNESS("tangential", tangential, "force per area and displacement across the normal"),
};

static const segment_spring whole_spring = {.range = {0, INFINITY}};

const key_table segment_spring_keys = {
    .name = "segment_spring",
    .size = sizeof(segment_spring),
    .nkey = COUNT(spring_list),
    .keys = spring_list,
    .initial = &whole_spring,
    .about = "an elastic foundation under a face",
};

static const key hold_list[] = {
    PART_OF(segment_hold, "hold"),
    {.name = "motion",
     .kind = KEY_ROWS,
     .dimension = DIM_LENGTH,
     .min = -MOST_METRES,
     .max = MOST_METRES,
     .count = 3,
     .max_count = 1,
     .open = true,
     .required = true,
     .offset = offsetof(segment_hold, motion),
     .about = "[x, y, z]: 0 holds a direction, ~ leaves it free, another number is where loads "
              "with `move_holds` move it"},
};

static const segment_hold whole_hold = {.range = {0, INFINITY}};

const key_table segment_hold_keys = {
    .name = "segment_hold",
    .size = sizeof(segment_hold),
    .nkey = COUNT(hold_list),
    .keys = hold_list,
    .initial = &whole_hold,
    .about = "a face that is held in some directions",
};

#define TIP_SPRING(word, dim, member, text)                                                        \
    {                                                                                              \
        .name = word, .kind = KEY_VECTOR, .dimension = dim, .min = 0, .max = MOST_STIFFNESS,       \
        .count = 3, .offset = offsetof(segment_tip_spring, member), .initial = "[0, 0, 0]",        \
        .about = text                                                                              \
    }

static const key tip_spring_list[] = {
    TIP_SPRING("translation", DIM_FORCE_PER_LENGTH, translation,
               "force per displacement of the geometric centre along x, y, z"),
    TIP_SPRING("rotation", DIM_MOMENT_PER_ANGLE, rotation, "moment per rotation about x, y, z"),
};

const key_table segment_tip_spring_keys = {
    .name = "segment_tip_spring",
    .size = sizeof(segment_tip_spring),
    .nkey = COUNT(tip_spring_list),
    .keys = tip_spring_list,
    .about = "springs between the tip and the ground",
};
