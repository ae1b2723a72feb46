// rodsolver/rod_keys.c
#include "rodsolver/rod_case.h"

static const key tendon_key_list[] = {
    {.name = "name",
     .kind = KEY_TEXT,
     .offset = offsetof(tendon_spec, name),
     .about = "what messages and reports call it"},
    {.name = "radius",
     .kind = KEY_FIELD,
     .dimension = DIM_LENGTH,
     .offset = offsetof(tendon_spec, radius),
     .initial = "0",
     .about = "distance from the geometric centre; may vary along s"},
    {.name = "angle",
     .kind = KEY_FIELD,
     .dimension = DIM_ANGLE,
     .offset = offsetof(tendon_spec, angle),
     .initial = "0",
     .about = "from +x towards +y; may vary along s"},
    {.name = "x",
     .kind = KEY_FIELD,
     .dimension = DIM_LENGTH,
     .offset = offsetof(tendon_spec, x),
     .initial = "0",
     .about = "added to the polar place; may vary along s"},
    {.name = "y",
     .kind = KEY_FIELD,
     .dimension = DIM_LENGTH,
     .offset = offsetof(tendon_spec, y),
     .initial = "0",
     .about = "added to the polar place; may vary along s"},
    {.name = "end",
     .kind = KEY_REAL,
     .dimension = DIM_LENGTH,
     .min = 1e-9,
     .max = 1e3,
     .offset = offsetof(tendon_spec, end),
     .initial = "the tip",
     .about = "arclength where the tendon is anchored"},
};

static const key_table tendon_keys = {
    .name = "tendon",
    .size = sizeof(tendon_spec),
    .nkey = sizeof tendon_key_list / sizeof *tendon_key_list,
    .keys = tendon_key_list,
    .about = "a frictionless tendon from the base to its end",
};

static const key rod_key_list[] = {
    {.name = "length",
     .kind = KEY_REAL,
     .dimension = DIM_LENGTH,
     .min = 1e-6,
     .max = 1e3,
     .required = true,
     .offset = offsetof(rod_case, length),
     .about = "of the unloaded geometric centreline"},
    {.name = "tendons",
     .kind = KEY_LIST,
     .max_count = ROD_CASE_TENDONS,
     .offset = offsetof(rod_case, tendons),
     .table = &tendon_keys,
     .about = "tendons, in the order of the tensions"},
    {.name = "tensions",
     .kind = KEY_ROWS,
     .dimension = DIM_FORCE,
     .min = 0,
     .max = 1e9,
     .offset = offsetof(rod_case, tensions),
     .about = "one row per shape, one tension per tendon"},
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
    .nkey = sizeof rod_key_list / sizeof *rod_key_list,
    .keys = rod_key_list,
    .initial = &initial,
    .about = "the rod, its tendons and the tensions to solve for",
};

rod_case rod_case_default(void)
{
    return initial;
}

status rod_case_check(const rod_case *c, mark *where)
{
    const tendon_spec *tendon = c->tendons.items;
    for (int i = 0; i < c->tendons.count; i++) {
        if (tendon[i].end > c->length) {
            *where = tendon[i].at;
            return status_fail(ERR_INPUT, "tendon %d ends at %g m, beyond the rod's length of %g m",
                               i + 1, tendon[i].end, c->length);
        }
    }
    if (c->tensions.nrow > 0 && c->tensions.ncol != c->tendons.count) {
        *where = c->tensions.at;
        return status_fail(ERR_INPUT, "a row of tensions has %d numbers for %d tendons",
                           c->tensions.ncol, c->tendons.count);
    }
    for (int i = 0; i < c->tensions.nrow * c->tensions.ncol; i++) {
        if (!(c->tensions.a[i] >= 0)) {
            *where = c->tensions.at;
            return status_fail(ERR_INPUT, "tension %g N: tendons cannot push", c->tensions.a[i]);
        }
    }
    if (c->tendons.count > 0 && c->tensions.nrow == 0) {
        *where = c->tendons.at;
        return status_fail(ERR_INPUT, "tendons without tensions: add `tensions_N: [[...], ...]`");
    }
    return OK;
}
