// fem/segment_keys.c
// The map `fem` of a case, its checks and what is chosen where it says nothing.
#include "fem/segment.h"

#include <math.h>
#include <string.h>

static const key load_keys_of[] = {
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
};

static const segment_load load_initial = {.at_kind = -1};

static const key_table load_keys = {.name = "segment_load",
                                    .size = sizeof(segment_load),
                                    .nkey = sizeof load_keys_of / sizeof *load_keys_of,
                                    .keys = load_keys_of,
                                    .initial = &load_initial,
                                    .about = "one load on the tip of the 3D segment"};

static const key keys[] = {
    {.name = "length",
     .kind = KEY_REAL,
     .dimension = DIM_LENGTH,
     .min = 1e-6,
     .max = 10,
     .required = true,
     .offset = offsetof(segment_case, length),
     .about = "length of the segment"},
    {.name = "base",
     .kind = KEY_CHOICE,
     .choices = "clamped|free_to_contract",
     .offset = offsetof(segment_case, base),
     .initial = "clamped",
     .about = "free_to_contract holds u_z on the base plane and its mean motion only"},
    {.name = "tip",
     .kind = KEY_CHOICE,
     .choices = "rigid|E_proportional|uniform",
     .offset = offsetof(segment_case, tip),
     .initial = "rigid",
     .about =
         "how loads enter: by a rigid cap, by a traction E (a + b x + c y) with the wrench asked "
         "for, or by a uniform traction"},
    {.name = "loads",
     .kind = KEY_LIST,
     .max_count = 1000,
     .required = true,
     .offset = offsetof(segment_case, loads),
     .table = &load_keys,
     .about = "loads on the tip, each solved by itself"},
    {.name = "order",
     .kind = KEY_INTEGER,
     .max = ELEMENT_MAX_ORDER,
     .offset = offsetof(segment_case, order),
     .initial = "0",
     .about = "order of the 3D elements, 1 to 4; 0: chosen"},
    {.name = "layers",
     .kind = KEY_INTEGER,
     .max = 10000,
     .offset = offsetof(segment_case, layers),
     .initial = "0",
     .about = "elements along z, 2 or more; 0: chosen"},
    {.name = "grading",
     .kind = KEY_REAL,
     .max = 1e4,
     .offset = offsetof(segment_case, grading),
     .initial = "0",
     .about = "height of a middle layer over that of an end layer, 1 or more; 0: chosen"},
    {.name = "size",
     .kind = KEY_REAL,
     .dimension = DIM_LENGTH,
     .max = 10,
     .offset = offsetof(segment_case, size),
     .initial = "0",
     .about = "target edge length in the plane; 0: chosen"},
    {.name = "section_at",
     .kind = KEY_REAL,
     .dimension = DIM_LENGTH,
     .max = 1000,
     .offset = offsetof(segment_case, section_at),
     .initial = "0",
     .about = "arclength of the rod's section that is extruded"},
};

static const segment_case initial = {0}; // clamped, rigid, everything chosen

const key_table segment_keys = {.name = "segment_case",
                                .size = sizeof(segment_case),
                                .nkey = sizeof keys / sizeof *keys,
                                .keys = keys,
                                .initial = &initial,
                                .about = "the 3D segment"};

segment_case segment_case_default(void)
{
    return initial;
}

static bool is_zero(const double *v)
{
    return v[0] == 0 && v[1] == 0 && v[2] == 0;
}

static status check_load(const segment_load *load, int tip)
{
    if (is_zero(load->force) && is_zero(load->moment)) {
        return status_fail(ERR_INPUT, "load '%s' has neither force nor moment", load->name);
    }
    if (tip == TIP_UNIFORM && !is_zero(load->moment)) {
        return status_fail(ERR_INPUT, "load '%s': a uniform traction has no moment", load->name);
    }
    if (tip == TIP_UNIFORM && (mark_given(load->point.at) || load->at_kind >= 0)) {
        return status_fail(
            ERR_INPUT, "load '%s': a uniform traction acts at the area's centroid; leave `at` out",
            load->name);
    }
    return OK;
}

static const segment_load *find_load(const segment_load *items, int count, const char *name)
{
    for (int i = 0; i < count; i++) {
        if (strcmp(items[i].name, name) == 0) {
            return &items[i];
        }
    }
    return NULL;
}

status segment_case_check(const segment_case *c, mark *where)
{
    const segment_load *loads = c->loads.items;
    *where = c->at;
    if (c->layers == 1) {
        return status_fail(ERR_INPUT, "fem: one layer has no middle, layers is 2 or more");
    }
    if (c->grading != 0 && c->grading < 1) {
        return status_fail(ERR_INPUT, "fem: grading %g is less than 1", c->grading);
    }
    for (int i = 0; i < c->loads.count; i++) {
        *where = loads[i].at;
        const status st = check_load(&loads[i], c->tip);
        if (st != OK) {
            return st;
        }
        if (find_load(loads, i, loads[i].name)) {
            return status_fail(ERR_INPUT, "there are two loads '%s'", loads[i].name);
        }
    }
    return OK;
}

// --- what is chosen, measured on the segment of the paper's Fig. 4: tip motion to 3e-4 with 14 k
// unknowns

static const int CHOSEN_ORDER = 3;
static const double CHOSEN_SIZE = 0.5; // in-plane edge over the section's radius
static const double CHOSEN_END_LAYER =
    0.1; // end layer over the radius, from which layers double to the middle

segment_case segment_choose(const segment_case *c, double radius)
{
    segment_case out = *c;
    const double ends = c->length / 2 / (CHOSEN_END_LAYER * radius);
    const int doublings = (int)ceil(log2(1 + ends));
    const int half = doublings > 1 ? doublings : 1;
    out.order = c->order ? c->order : CHOSEN_ORDER;
    out.size = c->size > 0 ? c->size : CHOSEN_SIZE * radius;
    out.layers = c->layers ? c->layers : 2 * half;
    const int steps = (out.layers - 1) / 2;
    out.grading = c->grading > 0 ? c->grading : pow(2, steps < half - 1 ? steps : half - 1);
    return out;
}

// Above this the matrix's entries outgrow the int with which PETSc and MUMPS count them, and its
// factors the memory of most machines.
static const double MOST_UNKNOWNS = 1e7;

status segment_check_size(const segment_case *c, int nplane)
{
    const double unknowns = 3.0 * nplane * ((double)c->layers * c->order + 1);
    if (unknowns > MOST_UNKNOWNS) {
        return status_fail(ERR_RESOURCE,
                           "segment: %.3g million unknowns are more than %g million: take fewer "
                           "fem.layers, a lower fem.order or a larger fem.size_mm",
                           unknowns * 1e-6, MOST_UNKNOWNS * 1e-6);
    }
    return OK;
}
