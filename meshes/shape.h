// meshes/shape.h
// What a person draws: shapes laid on one another, a later shape on top of the earlier ones. Every
// number may vary along the rod; at one arclength the shapes freeze into outlines.
#pragma once

#include "base/key.h"
#include "base/material_frame.h"
#include "base/status.h"
#include "meshes/carrier.h"

// What a frozen shape is: ellipses, rounded rectangles, splines and drawings are loops of curves.
typedef enum shape_kind {
    KIND_ANNULUS,
    KIND_SECTOR,
    KIND_DISC,
    KIND_RECTANGLE,
    KIND_POLYGON,
    KIND_LOOPS,
    KIND_COUNT
} shape_kind;

typedef struct ring_spec { // annulus and sector (a sector of an annulus; inner radius 0 gives a
                           // slice of a disc)
    mark at;
    field outer_radius, inner_radius; // [m]
    field mid_angle, width;           // sector only; width is the full angular width [rad]
    field centre[2];                  // [m], 0 unless given: keys centre_x, centre_y
} ring_spec;

typedef struct disc_spec {
    mark at;
    field radius;
    field centre[2];
} disc_spec;

typedef struct rectangle_spec {
    mark at;
    field width, height; // along its own x and y [m]
    field angle;         // of its own x from the section's x [rad]
    field centre[2];
} rectangle_spec;

typedef struct hole_spec {
    mark at;
    key_rows points; // [n][2] [m]
} hole_spec;

typedef struct polygon_spec {
    mark at;
    key_rows points; // [n][2] [m], either sense of turning, not closed
    key_list holes;  // of hole_spec
    field angle;     // turned about `centre`, then moved there
    field centre[2];
} polygon_spec;

typedef struct ellipse_spec {
    mark at;
    field semi_axis_x, semi_axis_y; // along its own x and y [m]
    field angle;
    field centre[2];
} ellipse_spec;

typedef struct rounded_spec {
    mark at;
    field width, height, corner_radius; // [m]
    field angle;
    field centre[2];
} rounded_spec;

// Holes of one size: at places, or equally spaced on a circle.
typedef struct lumens_spec {
    mark at;
    field radius;        // [m]
    key_rows places;     // [n][2] [m]; not given: on the circle
    int count;           // on the circle
    field circle_radius; // [m]
    field first_angle;   // of the first one on the circle, from x [rad]
    field centre[2];     // of the circle, or what the places are counted from
} lumens_spec;

// Copies about the section's origin, equally spaced in angle.
typedef struct array_spec {
    mark at;
    int count;
    field radius;      // the shape is moved out along x by it before it is copied [m]
    field first_angle; // of the first copy [rad]
    bool turn;         // each copy is turned with its place, else only moved
} array_spec;

// What the axes of a shape's material are turned from.
typedef enum shape_axes {
    SHAPE_AXES_SECTION, // 1 = z, 2 = x, 3 = y
    SHAPE_AXES_TANGENT, // of rings, sectors and discs 2 goes along the circle about their centre;
                        // of others it is their own x axis
} shape_axes;

typedef struct shape_spec {
    mark at;
    ring_spec annulus, sector; // exactly one of them is given
    disc_spec disc;
    rectangle_spec rectangle;
    polygon_spec polygon;
    ellipse_spec ellipse;
    rounded_spec rounded_rectangle;
    polygon_spec spline; // through its points, and its holes' points
    lumens_spec lumens;
    array_spec array;
    key_text material;  // a name, or "none": the shape cuts a hole into what lies below; lumens
                        // without one cut
    int material_index; // set by section_case_bind; -1 for none
    int axes;           // shape_axes
    field fibre_angle, plane_angle; // of the material's axes from those [rad]
} shape_spec;

extern const key_table shape_keys; // one entry of `section.shapes`

typedef struct shape_list {
    int count;
    const shape_spec *items; // owned by the case
} shape_list;

// A frozen shape, SI. Rings, discs: centre, radii, and for a sector mid angle and width. Rectangle:
// centre, size, angle. Polygon: loops already turned and moved, outer loop first and
// counter-clockwise, holes clockwise. Loops: the same of curves, all of them counter-clockwise.
typedef struct outline {
    shape_kind kind;
    int material;     // -1 cuts
    mark at;          // for messages
    char called[64];  // for messages: "shape 2 (ellipse, copy 3)"
    bool declares;    // its angle (a sector: its mid angle) says how the pattern turns
    double centre[2]; // [m]
    double outer, inner, mid_angle, width;
    double size[2], angle;
    int nloop;
    int *loop_start;  // [nloop + 1], into point or piece
    double *point;    // [loop_start[nloop]][2] of a polygon
    carrier *piece;   // [loop_start[nloop]] of loops; each begins where the one before it ends
    double thickness; // of loops, INFINITY where it is not known [m]
    bool has_frame;   // its material's axes are those of `frame`, else the section's own
    material_frame frame;
} outline;

typedef struct section_outline {
    int count;
    outline *items;
    double turn; // declared turn of the pattern: the mid angle of the last sector; without one the
                 // angle of the last shape that has one or is an array; else 0 [rad]
    bool has_symmetry; // a sector declares its mid angle as a symmetry axis and nothing contradicts
                       // it
    double size;       // radius about the origin that holds everything [m]
} section_outline;

// The shapes at arclength s. ERR_INPUT with the shape's place in the case (status_place): radius
// inside out, width outside (0, 2 pi), a polygon that crosses itself, a hole outside its polygon, a
// number that is not finite, ...
status shapes_at(shape_list shapes, double s, section_outline *out);
void section_outline_free(section_outline *o);

// Size, declared turn and symmetry from the items. ERR_INPUT where nothing has a material, or for a
// size that must be a mistake of unit.
status section_outline_measure(section_outline *o);

bool shapes_vary(shape_list shapes);

// Which shape is thinnest, -1 where none has a thickness of its own (polygons), and how thick it is
// over the section's size: walls, holes, arcs and edges.
int section_thinnest_shape(const section_outline *o, double *part);

// Whether the shapes of b are those of a turned by *angle about the origin, to `tolerance` times
// the size. The candidate is b.turn - a.turn. It says nothing of the directions of materials.
bool section_outline_is_turned(const section_outline *a, const section_outline *b, double tolerance,
                               double *angle);
