// rodsolver/rod_keys.c
// The rod as a case writes it.
#include "rodsolver/rod_inner_keys.h"

#define COUNT(list) ((int)(sizeof(list) / sizeof *(list)))

// what acts is far below: such a number is a mistake in the unit
#define MOST_NEWTONS 1e9
#define MOST_METRES 1e3

#define LIST(word, most, member, inner, text)                                                      \
    {                                                                                              \
        .name = word, .kind = KEY_LIST, .max_count = most, .offset = offsetof(rod_case, member),   \
        .table = &inner, .about = text                                                             \
    }
#define TABLE(word, member, inner, text)                                                           \
    {                                                                                              \
        .name = word, .kind = KEY_TABLE, .offset = offsetof(rod_case, member), .table = &inner,    \
        .about = text                                                                              \
    }
#define FLAG(word, member, text)                                                                   \
    {                                                                                              \
        .name = word, .kind = KEY_FLAG, .offset = offsetof(rod_case, member), .initial = "false",  \
        .about = text                                                                              \
    }

static const key rod_key_list[] = {
    {.name = "length",
     .kind = KEY_REAL,
     .dimension = DIM_LENGTH,
     .min = 1e-6,
     .max = MOST_METRES,
     .required = true,
     .offset = offsetof(rod_case, length),
     .about = "of the unloaded geometric centreline"},
    TABLE("base", base, rod_base_keys, "where the rod is clamped"),
    TABLE("rest", rest, rod_rest_keys, "its shape at rest; left out, it is straight"),
    {.name = "breaks",
     .kind = KEY_ROWS,
     .dimension = DIM_LENGTH,
     .min = 0,
     .max = MOST_METRES,
     .max_count = 1000,
     .offset = offsetof(rod_case, breaks),
     .about =
         "arclengths where an expression in s jumps or has a kink; found by itself unless they "
         "are many and close"},
    LIST("tendons", ROD_CASE_TENDONS, tendons, rod_tendon_keys,
         "tendons, in the order of the tensions"),
    LIST("loads", ROD_CASE_LOADS, loads, rod_load_keys, "forces and moments at places"),
    LIST("line_loads", ROD_CASE_LOADS, line_loads, rod_line_load_keys,
         "forces and moments along the rod"),
    {.name = "gravity",
     .kind = KEY_VECTOR,
     .dimension = DIM_ACCELERATION,
     .min = -1e6,
     .max = 1e6,
     .count = 3,
     .offset = offsetof(rod_case, gravity),
     .initial = "[0, 0, 0]",
     .about = "fixed in space; needs a density of every material"},
    {.name = "tensions",
     .kind = KEY_ROWS,
     .dimension = DIM_FORCE,
     .min = 0,
     .max = MOST_NEWTONS,
     .max_count = ROD_CASE_SOLUTIONS,
     .open = true,
     .offset = offsetof(rod_case, tensions),
     .about = "one row per solution, one tension per tendon; ~ where the pulled length is given"},
    {.name = "pulls",
     .kind = KEY_ROWS,
     .dimension = DIM_LENGTH,
     .min = -MOST_METRES,
     .max = MOST_METRES,
     .max_count = ROD_CASE_SOLUTIONS,
     .open = true,
     .offset = offsetof(rod_case, pulls),
     .about = "one row per solution, the length of each tendon that is drawn out of the base; ~ "
              "where the tension is given"},
    {.name = "load_factors",
     .kind = KEY_ROWS,
     .min = -MOST_NEWTONS,
     .max = MOST_NEWTONS,
     .max_count = ROD_CASE_SOLUTIONS,
     .offset = offsetof(rod_case, factors),
     .about = "one row per solution, one factor per load: loads, line_loads, then gravity where "
              "there is any; left out, all are 1"},
    LIST("sweep", 8, sweep, rod_sweep_keys, "ranges of solutions"),
    {.name = "start",
     .kind = KEY_CHOICE,
     .choices = "rest|last",
     .offset = offsetof(rod_case, start),
     .initial = "rest",
     .about = "every solution is reached from rest, or from the solution before it"},
    FLAG("past_limit_points", past,
         "follow the equilibria past limit points, where the rod would snap"),
    FLAG("derivatives", derivatives,
         "how the tip moves with tensions, pulled lengths, loads and wrenches, in the JSON"),
    {.name = "frame",
     .kind = KEY_CHOICE,
     .choices = "gc|nc",
     .offset = offsetof(rod_case, frame),
     .initial = "gc",
     .about =
         "frame of the solve: geometric centre with the coupled 6x6, or stiffness centre with the "
         "precurved backbone; the shape is the same"},
    {.name = "tolerance",
     .kind = KEY_REAL,
     .min = ROD_MIN_TOLERANCE,
     .max = 1e-2,
     .offset = offsetof(rod_case, tolerance),
     .initial = "1e-9",
     .about = "error of the tip's position over the length"},
    {.name = "points",
     .kind = KEY_INTEGER,
     .min = 2,
     .max = 100000,
     .offset = offsetof(rod_case, points),
     .initial = "121",
     .about = "points of a shape that is written"},
};

// far below what a camera or a laser scanner tells, for some microseconds more
#define DEFAULT_TOLERANCE 1e-9
// one per millimetre of the paper's prototypes
#define DEFAULT_POINTS 121

static const rod_case initial = {
    .frame = FRAME_GC, .tolerance = DEFAULT_TOLERANCE, .points = DEFAULT_POINTS};

const key_table rod_keys = {
    .name = "rod",
    .size = sizeof(rod_case),
    .nkey = COUNT(rod_key_list),
    .keys = rod_key_list,
    .initial = &initial,
    .about = "the rod, its tendons and loads, and what to solve for",
};

rod_case rod_case_default(void)
{
    return initial;
}
