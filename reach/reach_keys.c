// reach/reach_keys.c
#include "reach/reach_case.h"

#include <math.h>

#define COUNT(list) ((int)(sizeof(list) / sizeof *(list)))

// what is farther is a mistake in the unit [m]
#define MOST_METRES 1e3
// a shaft that turns farther is meant in other units [rad]
#define MOST_TURN 1000.0
// a tip that is bent by more than a full circle crosses itself [rad]
#define FULL_CIRCLE 6.283185307179587
#define HALF_CIRCLE 3.141592653589793
#define MOST_NEWTON 1e6

static const double unit_metres[] = {1e-3, 1, 1e-2, 1e-6, 0.0254};

double reach_unit_metres(int unit)
{
    return unit_metres[unit];
}

// --- a scope

static const key rod_list[] = {
    {.name = "file",
     .kind = KEY_NAME,
     .offset = offsetof(scope_rod_case, file),
     .about = "another case, whose section and rod are taken; left out: this one's"},
    {.name = "set",
     .kind = KEY_TEXTS,
     .max_count = 64,
     .offset = offsetof(scope_rod_case, set),
     .about = "keys of that case with other values, KEY=VALUE as --set takes them: "
              "section.model=classical"},
};

static const key_table rod_table = {
    .name = "scope_rod",
    .size = sizeof(scope_rod_case),
    .nkey = COUNT(rod_list),
    .keys = rod_list,
    .about = "a tip that is a rod with tendons; `{}`: this case's own",
};

static const key arc_list[] = {
    {.name = "length",
     .kind = KEY_REAL,
     .dimension = DIM_LENGTH,
     .min = 1e-6,
     .max = MOST_METRES,
     .required = true,
     .offset = offsetof(scope_arc_case, length),
     .about = "of the tip that bends"},
    {.name = "bend",
     .kind = KEY_VECTOR,
     .dimension = DIM_ANGLE,
     .min = -FULL_CIRCLE,
     .max = FULL_CIRCLE,
     .count = 2,
     .required = true,
     .offset = offsetof(scope_arc_case, bend),
     .about = "least and most angle of the tip's end against its base"},
};

static const key_table arc_table = {
    .name = "scope_arc",
    .size = sizeof(scope_arc_case),
    .nkey = COUNT(arc_list),
    .keys = arc_list,
    .about = "a tip that bends to an arc of a circle, solved in closed form",
};

static const key scope_list[] = {
    {.name = "name",
     .kind = KEY_TEXT,
     .required = true,
     .offset = offsetof(scope_case, name),
     .about = "what tables and figures call it"},
    {.name = "radius",
     .kind = KEY_REAL,
     .dimension = DIM_LENGTH,
     .max = MOST_METRES,
     .required = true,
     .offset = offsetof(scope_case, radius),
     .about = "of shaft and tip: no part of the tissue may be nearer to the centreline"},
    {.name = "insertion",
     .kind = KEY_VECTOR,
     .dimension = DIM_LENGTH,
     .min = -MOST_METRES,
     .max = MOST_METRES,
     .count = 2,
     .required = true,
     .offset = offsetof(scope_case, insertion),
     .about = "least and most way of the tip's base along the entry line, from the entry point on"},
    {.name = "turn",
     .kind = KEY_VECTOR,
     .dimension = DIM_ANGLE,
     .min = -MOST_TURN,
     .max = MOST_TURN,
     .count = 2,
     .initial = "[-180, 180] degrees",
     .offset = offsetof(scope_case, turn),
     .about = "least and most turn about the entry line"},
    {.name = "tensions",
     .kind = KEY_ROWS,
     .dimension = DIM_FORCE,
     .min = 0,
     .max = MOST_NEWTON,
     .count = 2,
     .max_count = SCOPE_TENDONS,
     .offset = offsetof(scope_case, tensions),
     .about = "rod: least and most tension, a row for each of its tendons"},
    {.name = "strain_limit",
     .kind = KEY_FLAG,
     .initial = "false",
     .offset = offsetof(scope_case, strain_limit),
     .about = "rod: no pose counts in which a material is strained past its linear_strain; with "
              "one tendon its tension is limited so"},
    {.name = "rod",
     .kind = KEY_TABLE,
     .one_of = 1,
     .offset = offsetof(scope_case, rod),
     .table = &rod_table,
     .about = "its tip is a rod"},
    {.name = "constant_curvature",
     .kind = KEY_TABLE,
     .one_of = 1,
     .offset = offsetof(scope_case, constant_curvature),
     .table = &arc_table,
     .about = "its tip is an arc"},
};

static const scope_case scope_initial = {.turn = {-HALF_CIRCLE, HALF_CIRCLE}};

static const key_table scope_table = {
    .name = "reach_scope",
    .size = sizeof(scope_case),
    .nkey = COUNT(scope_list),
    .keys = scope_list,
    .initial = &scope_initial,
    .about = "a scope that slides along the entry line, turns about it and bends its tip",
};

// --- where it enters

#define PLACE(word, member, needed, group, text)                                                   \
    {                                                                                              \
        .name = word, .kind = KEY_VECTOR, .dimension = DIM_LENGTH, .min = -MOST_METRES,            \
        .max = MOST_METRES, .count = 3, .required = needed, .one_of = group,                       \
        .offset = offsetof(entry_case, member), .about = text                                      \
    }

static const key entry_list[] = {
    PLACE("point", point, true, 0, "of the line, from where insertion is counted"),
    {.name = "direction",
     .kind = KEY_VECTOR,
     .min = -1e9,
     .max = 1e9,
     .count = 3,
     .one_of = 1,
     .offset = offsetof(entry_case, direction),
     .about = "of insertion, of any length"},
    PLACE("towards", towards, false, 1, "another point, which insertion goes towards"),
    {.name = "free",
     .kind = KEY_REAL,
     .dimension = DIM_LENGTH,
     .max = MOST_METRES,
     .initial = "until the line first has room for the shaft",
     .offset = offsetof(entry_case, free),
     .about = "so far from the point on the shaft may be in tissue: the channel of the burr hole"},
};

static const key_table entry_table = {
    .name = "reach_entry",
    .size = sizeof(entry_case),
    .nkey = COUNT(entry_list),
    .keys = entry_list,
    .about = "the fixed line on which the shaft slides and turns",
};

// --- the map

static const key map_list[] = {
    {.name = "points",
     .kind = KEY_INTEGER,
     .min = 10,
     .max = REACH_MAP_POINTS,
     .initial = "10000",
     .offset = offsetof(reach_map_case, points),
     .about = "places on the tissue's surface, equally many per area"},
    {.name = "seed",
     .kind = KEY_INTEGER,
     .min = 0,
     .max = 2147483647,
     .initial = "1",
     .offset = offsetof(reach_map_case, seed),
     .about = "the same seed gives the same places"},
};

static const key_table map_table = {
    .name = "reach_map",
    .size = sizeof(reach_map_case),
    .nkey = COUNT(map_list),
    .keys = map_list,
    .about = "which share of the tissue's surface every scope reaches: where the tip's skin comes "
             "within tolerance and clearance, whatever `tip` says",
};

// --- the whole

static const key reach_list[] = {
    {.name = "tissue",
     .kind = KEY_NAME,
     .required = true,
     .offset = offsetof(reach_case, tissue),
     .about = "the wall of the space in which scopes move: a closed surface, STL, OBJ or PLY"},
    {.name = "tissue_unit",
     .kind = KEY_CHOICE,
     .choices = "mm|m|cm|um|in",
     .required = true,
     .offset = offsetof(reach_case, tissue_unit),
     .about = "of the numbers in that file"},
    {.name = "merge",
     .kind = KEY_REAL,
     .dimension = DIM_LENGTH,
     .max = MOST_METRES,
     .initial = "1e-7 of the surface's size",
     .offset = offsetof(reach_case, merge),
     .about = "corners of that file that are this near are one"},
    {.name = "targets",
     .kind = KEY_NAME,
     .offset = offsetof(reach_case, targets),
     .about = "a table with columns x [mm], y [mm], z [mm] and maybe name"},
    {.name = "entry",
     .kind = KEY_TABLE,
     .required = true,
     .offset = offsetof(reach_case, entry),
     .table = &entry_table,
     .about = "the line on which scopes come in"},
    {.name = "tolerance",
     .kind = KEY_REAL,
     .dimension = DIM_LENGTH,
     .min = 1e-6,
     .max = MOST_METRES,
     .initial = "1 mm",
     .offset = offsetof(reach_case, tolerance),
     .about = "a target is reached when the tip comes so near"},
    {.name = "tip",
     .kind = KEY_CHOICE,
     .choices = "centre|skin",
     .initial = "centre",
     .offset = offsetof(reach_case, tip),
     .about = "what of the tip: the end of its centreline, or the ball of the scope's radius "
              "about it"},
    {.name = "clearance",
     .kind = KEY_REAL,
     .dimension = DIM_LENGTH,
     .max = MOST_METRES,
     .initial = "0",
     .offset = offsetof(reach_case, clearance),
     .about = "between body and tissue, which is left at least"},
    {.name = "path",
     .kind = KEY_CHOICE,
     .choices = "final_pose|insertion",
     .initial = "final_pose",
     .offset = offsetof(reach_case, path),
     .about = "what may not touch: the body in its last pose, as the paper has it, or on a whole "
              "way in"},
    {.name = "synthetic",
     .kind = KEY_FLAG,
     .initial = "false",
     .offset = offsetof(reach_case, synthetic),
     .about = "the anatomy is nobody's: said wherever it is shown"},
    {.name = "source",
     .kind = KEY_TEXT,
     .offset = offsetof(reach_case, source),
     .about = "where the anatomy comes from"},
    {.name = "paper",
     .kind = KEY_CHOICE,
     .choices = "none|table_4",
     .initial = "none",
     .offset = offsetof(reach_case, paper),
     .about = "the table of the paper whose counts stand beside, as printed there, on an anatomy "
              "that is not published"},
    {.name = "map",
     .kind = KEY_TABLE,
     .offset = offsetof(reach_case, map),
     .table = &map_table,
     .about = "the reach map of the tissue's surface"},
    {.name = "scopes",
     .kind = KEY_LIST,
     .max_count = REACH_SCOPES,
     .required = true,
     .offset = offsetof(reach_case, scopes),
     .table = &scope_table,
     .about = "the scopes that are compared"},
    {.name = "design",
     .kind = KEY_TABLE,
     .offset = offsetof(reach_case, design),
     .table = &design_keys,
     .about = "a search for a scope that reaches more"},
};

const key_table reach_keys = {
    .name = "reach",
    .size = sizeof(reach_case),
    .nkey = COUNT(reach_list),
    .keys = reach_list,
    .about = "which targets scopes reach that enter along a fixed line",
};

reach_case reach_case_default(void)
{
    return (reach_case){
        .tolerance = 1e-3, // the paper's
        .entry = {.towards = {NAN, NAN, NAN}, .free = NAN},
        .map = {.points = 10000, .seed = 1},
        .design = {.islands = 4, .evaluations = 200, .seed = 1},
    };
}
