// rodsolver/rod_load_keys.c
// Loads and sweeps as a case writes them.
#include "rodsolver/rod_inner_keys.h"

#include <math.h>

#define COUNT(list) ((int)(sizeof(list) / sizeof *(list)))

#define MOST_METRES 1e3
#define FRAMES "space|body"
#define FRAME_ABOUT "directions fixed in space, or turning with the section"
#define NAME_ABOUT "what messages, sweeps and reports call it"

#define VECTOR(word, kind_, dim, n, struct_, member, text)                                         \
    {                                                                                              \
        .name = word, .kind = kind_, .dimension = dim, .count = n,                                 \
        .offset = offsetof(struct_, member), .initial = n == 3 ? "[0, 0, 0]" : "[0, 0]",           \
        .about = text                                                                              \
    }

static const key load_list[] = {
    {.name = "name", .kind = KEY_TEXT, .offset = offsetof(point_load, name), .about = NAME_ABOUT},
    {.name = "at_s",
     .kind = KEY_REAL,
     .dimension = DIM_LENGTH,
     .min = 0,
     .max = MOST_METRES,
     .offset = offsetof(point_load, s),
     .initial = "the tip",
     .about = "arclength where it acts"},
    {.name = "frame",
     .kind = KEY_CHOICE,
     .choices = FRAMES,
     .offset = offsetof(point_load, frame),
     .initial = "space",
     .about = FRAME_ABOUT},
    VECTOR("force", KEY_VECTOR, DIM_FORCE, 3, point_load, force, "in that frame"),
    VECTOR("moment", KEY_VECTOR, DIM_MOMENT, 3, point_load, moment, "in that frame"),
    VECTOR("place", KEY_VECTOR, DIM_LENGTH, 2, point_load, place,
           "x, y in the section where the force acts"),
};

// beyond every length: the tip
static const point_load tip_load = {.s = INFINITY};

const key_table rod_load_keys = {
    .name = "rod load",
    .size = sizeof(point_load),
    .nkey = COUNT(load_list),
    .keys = load_list,
    .initial = &tip_load,
    .about = "a force and a moment at one place",
};

static const key line_load_list[] = {
    {.name = "name", .kind = KEY_TEXT, .offset = offsetof(line_load, name), .about = NAME_ABOUT},
    {.name = "from",
     .kind = KEY_REAL,
     .dimension = DIM_LENGTH,
     .min = 0,
     .max = MOST_METRES,
     .offset = offsetof(line_load, from),
     .initial = "0",
     .about = "arclength where it begins"},
    {.name = "to",
     .kind = KEY_REAL,
     .dimension = DIM_LENGTH,
     .min = 1e-9,
     .max = MOST_METRES,
     .offset = offsetof(line_load, to),
     .initial = "the tip",
     .about = "arclength where it ends"},
    {.name = "frame",
     .kind = KEY_CHOICE,
     .choices = FRAMES,
     .offset = offsetof(line_load, frame),
     .initial = "space",
     .about = FRAME_ABOUT},
    VECTOR("force", KEY_FIELDS, DIM_FORCE_PER_LENGTH, 3, line_load, force,
           "per arclength of the rod at rest"),
    VECTOR("moment", KEY_FIELDS, DIM_MOMENT_PER_LENGTH, 3, line_load, moment,
           "per arclength of the rod at rest"),
    VECTOR("place", KEY_FIELDS, DIM_LENGTH, 2, line_load, place,
           "x, y in the section where the force acts"),
};

const key_table rod_line_load_keys = {
    .name = "rod line load",
    .size = sizeof(line_load),
    .nkey = COUNT(line_load_list),
    .keys = line_load_list,
    .about = "a load along a stretch of the rod",
};

#define OF(word, which, text)                                                                      \
    {                                                                                              \
        .name = word, .kind = KEY_NAME, .one_of = 1, .offset = offsetof(sweep_case, of[which]),    \
        .about = text                                                                              \
    }

#define RANGE(dim, least, most, which, what)                                                       \
    {.name = "from",                                                                               \
     .kind = KEY_REAL,                                                                             \
     .dimension = dim,                                                                             \
     .min = least,                                                                                 \
     .max = most,                                                                                  \
     .offset = offsetof(sweep_case, from[which]),                                                  \
     .about = "the first " what},                                                                  \
    {                                                                                              \
        .name = "to", .kind = KEY_REAL, .dimension = dim, .min = least, .max = most,               \
        .offset = offsetof(sweep_case, to[which]), .about = "the last " what                       \
    }

static const key sweep_list[] = {
    OF("tension_of", SWEEP_TENSION, "the tendon whose tension goes from `from_N` to `to_N`"),
    OF("pull_of", SWEEP_PULL, "the tendon whose pulled length goes from `from_mm` to `to_mm`"),
    OF("load", SWEEP_LOAD, "the load, or `gravity`, whose factor goes from `from` to `to`"),
    RANGE(DIM_FORCE, 0, 1e9, SWEEP_TENSION, "tension"),
    RANGE(DIM_LENGTH, -MOST_METRES, MOST_METRES, SWEEP_PULL, "pulled length"),
    RANGE(DIM_NONE, -1e9, 1e9, SWEEP_LOAD, "factor"),
    {.name = "steps",
     .kind = KEY_INTEGER,
     .min = 1,
     .max = ROD_CASE_SOLUTIONS - 1,
     .required = true,
     .offset = offsetof(sweep_case, steps),
     .about = "equal steps between the two: one solution more than steps"},
};

static const sweep_case open_sweep = {.from = {NAN, NAN, NAN}, .to = {NAN, NAN, NAN}};

const key_table rod_sweep_keys = {
    .name = "sweep",
    .size = sizeof(sweep_case),
    .nkey = COUNT(sweep_list),
    .keys = sweep_list,
    .initial = &open_sweep,
    .about = "a range of solutions, for every row of tensions; several make a grid, the last one "
             "running fastest",
};
