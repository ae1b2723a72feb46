// fem/segment_keys.c
// The map `fem` of a case, and what is chosen where it says nothing.
#include "fem/segment_inner_keys.h"

#include <math.h>

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
     .choices = "clamped|free_to_contract|free",
     .offset = offsetof(segment_case, base),
     .initial = "clamped",
     .about = "free_to_contract holds u_z on the base plane and its mean motion only; free leaves "
              "all to springs and holds"},
    {.name = "tip",
     .kind = KEY_CHOICE,
     .choices = "rigid|E_proportional|uniform|free",
     .offset = offsetof(segment_case, tip),
     .initial = "rigid",
     .about =
         "how loads enter: by a rigid cap, by a traction E (a + b x + c y) with the wrench asked "
         "for, by a uniform traction, or on other faces only"},
    {.name = "tip_spring",
     .kind = KEY_TABLE,
     .offset = offsetof(segment_case, tip_spring),
     .table = &segment_tip_spring_keys,
     .about = "springs between the tip and the ground"},
    {.name = "loads",
     .kind = KEY_LIST,
     .max_count = 1000,
     .required = true,
     .offset = offsetof(segment_case, loads),
     .table = &segment_load_keys,
     .about = "loads, each solved by itself"},
    {.name = "springs",
     .kind = KEY_LIST,
     .max_count = 256,
     .offset = offsetof(segment_case, springs),
     .table = &segment_spring_keys,
     .about = "elastic foundations under faces"},
    {.name = "holds",
     .kind = KEY_LIST,
     .max_count = 256,
     .offset = offsetof(segment_case, holds),
     .table = &segment_hold_keys,
     .about = "faces that are held beside the base"},
    {.name = "body",
     .kind = KEY_CHOICE,
     .choices = "along|prism",
     .offset = offsetof(segment_case, course),
     .initial = "along",
     .about = "the body follows the section and the rest shape along the rod from `section_at` on, "
              "or keeps the section of that place"},
    {.name = "method",
     .kind = KEY_CHOICE,
     .choices = "auto|doubling|direct|iterative",
     .offset = offsetof(segment_case, way),
     .initial = "auto",
     .about = "how it is solved: a slab joined with itself again and again (prisms, turning ones "
              "too), sparse factors, or conjugate gradients; auto takes the cheapest"},
    {.name = "tolerance",
     .kind = KEY_REAL,
     .min = SEGMENT_MIN_TOLERANCE,
     .max = 0.1,
     .offset = offsetof(segment_case, tolerance),
     .initial = "the mesh as it is",
     .about = "meshes are refined until the estimated error of every load's work and tip motion, "
              "without loads of the tip's compliance and the middle's 6x6, is below it"},
    {.name = "mixed",
     .kind = KEY_CHOICE,
     .choices = "auto|yes|no",
     .offset = offsetof(segment_case, mixed),
     .initial = "auto",
     .about = "the change of volume on a lower order, so that nothing locks as nu nears 1/2; auto: "
              "where nu is large"},
    {.name = "stress",
     .kind = KEY_FLAG,
     .offset = offsetof(segment_case, stress),
     .initial = "false",
     .about = "stresses into the result's file"},
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
     .about = "arclength of the rod's section at the segment's base"},
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
