// meshes/shape_keys.c
#include "meshes/shape.h"

#include <math.h>

// Drawn lengths lie between these; the unit is most likely a mistake outside of them.
#define SMALLEST_LENGTH 1e-12
#define LARGEST_LENGTH 1e6

enum { MOST_POINTS = 2000, MOST_HOLES = 200, MOST_COPIES = 500 };

#define COUNT(keys) ((int)(sizeof(keys) / sizeof *(keys)))

#define LENGTH_KEY(word, type, member, words)                                                      \
    {                                                                                              \
        .name = word, .kind = KEY_FIELD, .dimension = DIM_LENGTH, .min = SMALLEST_LENGTH,          \
        .max = LARGEST_LENGTH, .required = true, .offset = offsetof(type, member), .about = words  \
    }

#define CENTRE_KEYS(type)                                                                          \
    {.name = "centre_x",                                                                           \
     .kind = KEY_FIELD,                                                                            \
     .dimension = DIM_LENGTH,                                                                      \
     .min = -LARGEST_LENGTH,                                                                       \
     .max = LARGEST_LENGTH,                                                                        \
     .initial = "0",                                                                               \
     .offset = offsetof(type, centre[0]),                                                          \
     .about = "x of its centre in the section"},                                                   \
    {                                                                                              \
        .name = "centre_y", .kind = KEY_FIELD, .dimension = DIM_LENGTH, .min = -LARGEST_LENGTH,    \
        .max = LARGEST_LENGTH, .initial = "0", .offset = offsetof(type, centre[1]),                \
        .about = "y of its centre in the section"                                                  \
    }

#define INNER_RADIUS_KEY                                                                           \
    {                                                                                              \
        .name = "inner_radius", .kind = KEY_FIELD, .dimension = DIM_LENGTH, .min = 0,              \
        .max = LARGEST_LENGTH, .required = true, .offset = offsetof(ring_spec, inner_radius),      \
        .about = "radius of the inner circle; 0: down to the centre"                               \
    }

#define ANGLE_KEY(type)                                                                            \
    {                                                                                              \
        .name = "angle", .kind = KEY_FIELD, .dimension = DIM_ANGLE, .initial = "0",                \
        .offset = offsetof(type, angle),                                                           \
        .about = "turn of its own x axis from the section's x axis, about its centre"              \
    }

static const key annulus_key_list[] = {
    LENGTH_KEY("outer_radius", ring_spec, outer_radius, "radius of the outer circle"),
    INNER_RADIUS_KEY,
    CENTRE_KEYS(ring_spec),
};

static const key_table annulus_keys = {.name = "annulus",
                                       .size = sizeof(ring_spec),
                                       .nkey = COUNT(annulus_key_list),
                                       .keys = annulus_key_list,
                                       .about = "a full ring"};

static const key sector_key_list[] = {
    LENGTH_KEY("outer_radius", ring_spec, outer_radius, "radius of the outer circle"),
    INNER_RADIUS_KEY,
    {.name = "mid_angle",
     .kind = KEY_FIELD,
     .dimension = DIM_ANGLE,
     .required = true,
     .offset = offsetof(ring_spec, mid_angle),
     .about = "direction of its middle from the x axis; declares how the pattern turns along s"},
    {.name = "width",
     .kind = KEY_FIELD,
     .dimension = DIM_ANGLE,
     .min = 0,
     .max = 2 * 3.14159265358979323846,
     .required = true,
     .offset = offsetof(ring_spec, width),
     .about = "full angular width, more than 0 and less than 2 pi"},
    CENTRE_KEYS(ring_spec),
};

static const key_table sector_keys = {.name = "sector",
                                      .size = sizeof(ring_spec),
                                      .nkey = COUNT(sector_key_list),
                                      .keys = sector_key_list,
                                      .about = "a part of a ring between two angles"};

static const key disc_key_list[] = {
    LENGTH_KEY("radius", disc_spec, radius, "radius of the circle"),
    CENTRE_KEYS(disc_spec),
};

static const key_table disc_keys = {.name = "disc",
                                    .size = sizeof(disc_spec),
                                    .nkey = COUNT(disc_key_list),
                                    .keys = disc_key_list,
                                    .about = "a full circle"};

static const key rectangle_key_list[] = {
    LENGTH_KEY("width", rectangle_spec, width, "edge along its own x axis"),
    LENGTH_KEY("height", rectangle_spec, height, "edge along its own y axis"),
    ANGLE_KEY(rectangle_spec),
    CENTRE_KEYS(rectangle_spec),
};

static const key_table rectangle_keys = {.name = "rectangle",
                                         .size = sizeof(rectangle_spec),
                                         .nkey = COUNT(rectangle_key_list),
                                         .keys = rectangle_key_list,
                                         .about = "a rectangle about its centre"};

#define POINTS_KEY(type, words)                                                                    \
    {                                                                                              \
        .name = "points", .kind = KEY_ROWS, .dimension = DIM_LENGTH, .min = -LARGEST_LENGTH,       \
        .max = LARGEST_LENGTH, .count = 2, .max_count = MOST_POINTS, .required = true,             \
        .offset = offsetof(type, points), .about = words                                           \
    }

static const char corner_words[] =
    "corners [x, y] in order, either sense; the last joins the first";
static const char point_words[] =
    "points [x, y] in order, either sense, that a smooth closed curve goes through";

static const key hole_key_list[] = {POINTS_KEY(hole_spec, corner_words)};

static const key_table hole_keys = {.name = "hole",
                                    .size = sizeof(hole_spec),
                                    .nkey = COUNT(hole_key_list),
                                    .keys = hole_key_list,
                                    .about = "a polygonal hole, inside its polygon"};

static const key polygon_key_list[] = {
    POINTS_KEY(polygon_spec, corner_words),
    {.name = "holes",
     .kind = KEY_LIST,
     .max_count = MOST_HOLES,
     .offset = offsetof(polygon_spec, holes),
     .table = &hole_keys,
     .about = "holes in the polygon; they neither touch it nor one another"},
    ANGLE_KEY(polygon_spec),
    CENTRE_KEYS(polygon_spec),
};

static const key_table polygon_keys = {.name = "polygon",
                                       .size = sizeof(polygon_spec),
                                       .nkey = COUNT(polygon_key_list),
                                       .keys = polygon_key_list,
                                       .about = "straight edges between corners"};

static const key ellipse_key_list[] = {
    LENGTH_KEY("semi_axis_x", ellipse_spec, semi_axis_x, "half its length along its own x axis"),
    LENGTH_KEY("semi_axis_y", ellipse_spec, semi_axis_y, "half its length along its own y axis"),
    ANGLE_KEY(ellipse_spec),
    CENTRE_KEYS(ellipse_spec),
};

static const key_table ellipse_keys = {.name = "ellipse",
                                       .size = sizeof(ellipse_spec),
                                       .nkey = COUNT(ellipse_key_list),
                                       .keys = ellipse_key_list,
                                       .about = "a full ellipse"};

static const key rounded_key_list[] = {
    LENGTH_KEY("width", rounded_spec, width, "extent along its own x axis"),
    LENGTH_KEY("height", rounded_spec, height, "extent along its own y axis"),
    {.name = "corner_radius",
     .kind = KEY_FIELD,
     .dimension = DIM_LENGTH,
     .min = 0,
     .max = LARGEST_LENGTH,
     .required = true,
     .offset = offsetof(rounded_spec, corner_radius),
     .about = "of its four corners, at most half the shorter edge"},
    ANGLE_KEY(rounded_spec),
    CENTRE_KEYS(rounded_spec),
};

static const key_table rounded_rectangle_keys = {
    .name = "rounded rectangle",
    .size = sizeof(rounded_spec),
    .nkey = COUNT(rounded_key_list),
    .keys = rounded_key_list,
    .about = "a rectangle with round corners, about its centre"};

static const key spline_hole_key_list[] = {POINTS_KEY(hole_spec, point_words)};

static const key_table spline_hole_keys = {.name = "spline hole",
                                           .size = sizeof(hole_spec),
                                           .nkey = COUNT(spline_hole_key_list),
                                           .keys = spline_hole_key_list,
                                           .about = "a smooth hole, inside its spline"};

static const key spline_key_list[] = {
    POINTS_KEY(polygon_spec, point_words),
    {.name = "holes",
     .kind = KEY_LIST,
     .max_count = MOST_HOLES,
     .offset = offsetof(polygon_spec, holes),
     .table = &spline_hole_keys,
     .about = "smooth holes in it; they neither touch it nor one another"},
    ANGLE_KEY(polygon_spec),
    CENTRE_KEYS(polygon_spec),
};

static const key_table spline_keys = {.name = "spline",
                                      .size = sizeof(polygon_spec),
                                      .nkey = COUNT(spline_key_list),
                                      .keys = spline_key_list,
                                      .about = "a smooth outline through points: periodic cubic "
                                               "pieces over the length of the chords"};

static const key lumens_key_list[] = {
    LENGTH_KEY("radius", lumens_spec, radius, "radius of each"),
    {.name = "at",
     .kind = KEY_ROWS,
     .dimension = DIM_LENGTH,
     .min = -LARGEST_LENGTH,
     .max = LARGEST_LENGTH,
     .count = 2,
     .max_count = MOST_COPIES,
     .one_of = 1,
     .offset = offsetof(lumens_spec, places),
     .about = "their centres [x, y]"},
    {.name = "count",
     .kind = KEY_INTEGER,
     .min = 1,
     .max = MOST_COPIES,
     .one_of = 1,
     .offset = offsetof(lumens_spec, count),
     .about = "how many, equally spaced on a circle"},
    {.name = "circle_radius",
     .kind = KEY_FIELD,
     .dimension = DIM_LENGTH,
     .min = 0,
     .max = LARGEST_LENGTH,
     .initial = "0",
     .offset = offsetof(lumens_spec, circle_radius),
     .about = "of the circle that their centres lie on, with count"},
    {.name = "first_angle",
     .kind = KEY_FIELD,
     .dimension = DIM_ANGLE,
     .initial = "0",
     .offset = offsetof(lumens_spec, first_angle),
     .about = "direction of the first one on the circle, from the x axis"},
    CENTRE_KEYS(lumens_spec),
};

static const key_table lumens_keys = {.name = "lumens",
                                      .size = sizeof(lumens_spec),
                                      .nkey = COUNT(lumens_key_list),
                                      .keys = lumens_key_list,
                                      .about = "round holes of one size; with a material they are "
                                               "filled"};

static const key array_key_list[] = {
    {.name = "count",
     .kind = KEY_INTEGER,
     .min = 1,
     .max = MOST_COPIES,
     .required = true,
     .offset = offsetof(array_spec, count),
     .about = "how many copies, equally spaced in angle about the section's origin"},
    {.name = "radius",
     .kind = KEY_FIELD,
     .dimension = DIM_LENGTH,
     .min = 0,
     .max = LARGEST_LENGTH,
     .initial = "0",
     .offset = offsetof(array_spec, radius),
     .about = "the shape is moved out along x by it before it is copied"},
    {.name = "first_angle",
     .kind = KEY_FIELD,
     .dimension = DIM_ANGLE,
     .initial = "0",
     .offset = offsetof(array_spec, first_angle),
     .about = "direction of the first copy, from the shape's own place"},
    {.name = "turn",
     .kind = KEY_FLAG,
     .initial = "true",
     .offset = offsetof(array_spec, turn),
     .about = "each copy turns with its place; false: it is only moved there"},
};

static const array_spec array_initial = {.count = 1, .turn = true};

static const key_table array_keys = {.name = "array",
                                     .size = sizeof(array_spec),
                                     .nkey = COUNT(array_key_list),
                                     .keys = array_key_list,
                                     .initial = &array_initial,
                                     .about = "copies of the shape around a circle"};

#define SHAPE_KEY(word, words)                                                                     \
    {                                                                                              \
        .name = #word, .kind = KEY_TABLE, .one_of = 1, .offset = offsetof(shape_spec, word),       \
        .table = &word##_keys, .about = words                                                      \
    }

static const key shape_key_list[] = {
    SHAPE_KEY(annulus, "a full ring"),
    SHAPE_KEY(sector, "a part of a ring between two angles"),
    SHAPE_KEY(disc, "a full circle"),
    SHAPE_KEY(rectangle, "a rectangle, turned or not"),
    SHAPE_KEY(polygon, "straight edges between corners, with holes if need be"),
    SHAPE_KEY(ellipse, "a full ellipse, turned or not"),
    SHAPE_KEY(rounded_rectangle, "a rectangle with round corners"),
    SHAPE_KEY(spline, "a smooth closed curve through points, with holes if need be"),
    SHAPE_KEY(lumens, "round holes of one size in what lies below, at places or on a circle"),
    {.name = "array",
     .kind = KEY_TABLE,
     .offset = offsetof(shape_spec, array),
     .table = &array_keys,
     .about = "copies of the shape around the section's origin"},
    {.name = "material",
     .kind = KEY_NAME,
     .offset = offsetof(shape_spec, material),
     .about = "a name from `materials`; none: the shape cuts a hole into what lies below it; "
              "required but for lumens, which cut without one"},
    {.name = "axes",
     .kind = KEY_CHOICE,
     .choices = "section|tangent",
     .initial = "section",
     .offset = offsetof(shape_spec, axes),
     .about = "own axes of a directed material; section: 1 = z, 2 = x, 3 = y; tangent: 1 = z, and "
              "2 follows the circle about the centre of a ring, sector or disc (3 points inwards), "
              "or is the own x axis of another shape"},
    {.name = "fibre_angle",
     .kind = KEY_FIELD,
     .dimension = DIM_ANGLE,
     .initial = "0",
     .offset = offsetof(shape_spec, fibre_angle),
     .about = "turn of the material's axes 1 and 2 about 3, from 1 towards 2, after plane_angle; "
              "the material's own angles come on top"},
    {.name = "plane_angle",
     .kind = KEY_FIELD,
     .dimension = DIM_ANGLE,
     .initial = "0",
     .offset = offsetof(shape_spec, plane_angle),
     .about = "turn of the material's axes 2 and 3 about 1, from 2 towards 3"},
};

const key_table shape_keys = {.name = "shape",
                              .size = sizeof(shape_spec),
                              .nkey = COUNT(shape_key_list),
                              .keys = shape_key_list,
                              .about = "a shape with its material; it lies on top of the earlier "
                                       "shapes of the list"};
