// measure/scan_keys.c
// The keys of a scan.
#include "measure/scan.h"

#include <math.h>
#include <string.h>

#define COUNT(list) ((int)(sizeof(list) / sizeof *(list)))
#define NOT_GIVEN                                                                                  \
    {                                                                                              \
        NAN, NAN, NAN                                                                              \
    }
#define MOST_METRES 1e3 // what is farther is a mistake in the unit

#define PLACE(word, type, member, needed, text)                                                    \
    {                                                                                              \
        .name = word, .kind = KEY_VECTOR, .dimension = DIM_LENGTH, .min = -MOST_METRES,            \
        .max = MOST_METRES, .count = 3, .required = needed, .offset = offsetof(type, member),      \
        .about = text                                                                              \
    }
#define LENGTH(word, type, member, least, standard, text)                                          \
    {                                                                                              \
        .name = word, .kind = KEY_REAL, .dimension = DIM_LENGTH, .min = least, .max = MOST_METRES, \
        .offset = offsetof(type, member), .initial = standard, .about = text                       \
    }
#define TABLE(word, member, inner, text)                                                           \
    {                                                                                              \
        .name = word, .kind = KEY_TABLE, .offset = offsetof(scan_settings, member),                \
        .table = &inner, .about = text                                                             \
    }

static const struct {
    const char *name;
    double metres;
} units[SCAN_UNITS] = {{"mm", 1e-3}, {"m", 1}, {"cm", 1e-2}, {"um", 1e-6}, {"in", 0.0254}};

double scan_unit(int unit)
{
    return unit < 0 ? (double)NAN : units[unit].metres;
}

const char *scan_unit_name(double metres)
{
    for (int i = 0; i < SCAN_UNITS; i++) {
        if (fabs(units[i].metres / metres - 1) < 1e-6) { // rounding apart
            return units[i].name;
        }
    }
    return "units";
}

static const key fiducial_list[] = {
    {.name = "name",
     .kind = KEY_TEXT,
     .offset = offsetof(scan_fiducial, name),
     .about = "what messages call it"},
    PLACE("cloud", scan_fiducial, cloud, true, "where the scan shows it"),
    PLACE("rod", scan_fiducial, rod, true,
          "where it is in the rod's frame: z along the rod at its base"),
    LENGTH("sigma", scan_fiducial, sigma, 1e-9, "from the residuals",
           "standard deviation of its place, per direction; of all or of none"),
};
static const scan_fiducial fiducial_initial = {.sigma = NAN};
static const key_table fiducial_keys = {
    .name = "scan_fiducial",
    .size = sizeof(scan_fiducial),
    .nkey = COUNT(fiducial_list),
    .keys = fiducial_list,
    .initial = &fiducial_initial,
    .about = "a feature whose place is known in the scan and on the rod",
};

static const key base_list[] = {
    PLACE("point", scan_base, point, false, "where the body begins in the scan, to half a radius"),
    {.name = "direction",
     .kind = KEY_VECTOR,
     .min = -1e9,
     .max = 1e9,
     .count = 3,
     .offset = offsetof(scan_base, direction),
     .about = "of the body there, away from its base, to 20 degrees"},
};
static const scan_base base_initial = {.point = NOT_GIVEN, .direction = NOT_GIVEN};
static const key_table base_keys = {
    .name = "scan_base",
    .size = sizeof(scan_base),
    .nkey = COUNT(base_list),
    .keys = base_list,
    .initial = &base_initial,
    .about = "roughly where the body begins in the scan",
};

static const key plate_list[] = {
    PLACE("point", scan_plate, point, false, "a place of the scan that is on the plate"),
    LENGTH("reach", scan_plate, reach, 1e-6, "everywhere",
           "points this near to `point` are looked at"),
    LENGTH("noise", scan_plate, noise, 1e-9, "0.2 mm",
           "points within three of it of the plane are the plate's"),
};
#define PLATE_INITIAL                                                                              \
    {                                                                                              \
        .point = NOT_GIVEN, .reach = INFINITY, .noise = 0.2e-3                                     \
    }
static const scan_plate plate_initial = PLATE_INITIAL;
static const key_table plate_keys = {
    .name = "scan_plate",
    .size = sizeof(scan_plate),
    .nkey = COUNT(plate_list),
    .keys = plate_list,
    .initial = &plate_initial,
    .about = "the flat plate on which the rod stands: its plane is s = 0, its normal the rod's z",
};

static const key mark_list[] = {
    PLACE("point", scan_mark, point, true, "where the scan shows a feature beside the axis"),
    {.name = "angle",
     .kind = KEY_REAL,
     .dimension = DIM_ANGLE,
     .min = -100,
     .max = 100,
     .offset = offsetof(scan_mark, angle),
     .initial = "0",
     .about = "at which it is seen from the rod's axis, from x towards y"},
    LENGTH("sigma", scan_mark, sigma, 0, "0", "standard deviation of the feature's place"),
};
static const key_table mark_keys = {
    .name = "scan_mark",
    .size = sizeof(scan_mark),
    .nkey = COUNT(mark_list),
    .keys = mark_list,
    .about = "what fixes the turn about the rod's axis",
};

static const key scan_list[] = {
    {.name = "cloud",
     .kind = KEY_NAME,
     .offset = offsetof(scan_settings, cloud),
     .about = "the file of points: PLY, PCD, XYZ or CSV; from this file's folder"},
    {.name = "unit",
     .kind = KEY_CHOICE,
     .choices = "mm|m|cm|um|in",
     .offset = offsetof(scan_settings, unit),
     .initial = "what the columns' names say, else mm",
     .about = "of the lengths in the cloud's file"},
    {.name = "synthetic",
     .kind = KEY_FLAG,
     .offset = offsetof(scan_settings, synthetic),
     .initial = "false",
     .about = "the points are made, not measured: said wherever the result is shown"},
    LENGTH("radius", scan_settings, radius, 1e-6, "found", "outer radius of the body"),
    LENGTH("length", scan_settings, length, 1e-6, "found",
           "of the body: nothing is traced far beyond it"),
    LENGTH("noise", scan_settings, noise, 1e-9, "found", "of the scanner"),
    LENGTH("longest_gap", scan_settings, longest_gap, 0, "six radii",
           "a stretch without points that is bridged"),
    LENGTH("spacing", scan_settings, spacing, 1e-6, "a quarter radius",
           "of the centreline's points"),
    LENGTH("smoothing", scan_settings, smoothing, 1e-9, "by cross-validation",
           "length below which the line is smoothed"),
    {.name = "box",
     .kind = KEY_ROWS,
     .dimension = DIM_LENGTH,
     .min = -MOST_METRES,
     .max = MOST_METRES,
     .count = 3,
     .max_count = 2,
     .offset = offsetof(scan_settings, box),
     .about = "two corners in the scan: what lies outside is left out"},
    TABLE("base", base, base_keys, "roughly where the body begins"),
    {.name = "fiducials",
     .kind = KEY_LIST,
     .max_count = SCAN_MOST_FIDUCIALS,
     .offset = offsetof(scan_settings, fiducials),
     .table = &fiducial_keys,
     .about = "three or more features that fix the rod's frame"},
    TABLE("plate", plate, plate_keys, "without fiducials: the plate that fixes the rod's axis"),
    TABLE("mark", mark, mark_keys, "without fiducials: what fixes the turn about the axis"),
    {.name = "seed",
     .kind = KEY_INTEGER,
     .min = 1,
     .max = 1e9,
     .offset = offsetof(scan_settings, seed),
     .initial = "1",
     .about = "of the random choices"},
};
static const scan_settings scan_initial = {
    .unit = -1,
    .radius = NAN,
    .length = NAN,
    .noise = NAN,
    .longest_gap = NAN,
    .spacing = NAN,
    .smoothing = NAN,
    .base = {.point = NOT_GIVEN, .direction = NOT_GIVEN},
    .plate = PLATE_INITIAL,
    .seed = 1,
};
const key_table scan_keys = {
    .name = "scan",
    .size = sizeof(scan_settings),
    .nkey = COUNT(scan_list),
    .keys = scan_list,
    .initial = &scan_initial,
    .about = "points of a tube as a scanner gave them, and what is known of it",
};
