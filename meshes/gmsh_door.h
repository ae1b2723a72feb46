// meshes/gmsh_door.h
// What the gmsh module takes and gives: shapes as loops of sides in; straight triangles, the faces
// they fill and the curves they follow out. Plain types only. All lengths are in units of the
// section's size, since gmsh's tolerances are absolute.
#pragma once

#include "meshes/shape.h"

#include <stdbool.h>

typedef enum side_kind {
    SIDE_LINE,
    SIDE_ARC,     // about `centre`, less than a half turn, the short way
    SIDE_CIRCLE,  // about `centre`, alone in its loop
    SIDE_ELLIPSE, // an arc of one, as a rational curve with one control point between its ends
    SIDE_BEZIER,  // a cubic, with two control points between its ends
} side_kind;

// From `from` to where the loop's next side begins.
typedef struct plane_side {
    side_kind kind;
    double from[2], centre[2];
    double control[2][2], weight; // weight: of the rational curve's control point
} plane_side;

enum { CURVE_PROBES = 33 };

// A fragment is what the shapes' edges divide the plane into: a face, bounded by curves.
typedef struct plane_pieces {
    int nface, ncurve;
    int *owner;     // [nface] index of the shape on top; faces without material are left out
    double *area;   // [nface] of the exact geometry
    double *around; // [nface] length of its boundary
    int *tag;       // [ncurve] gmsh's name of it
    double *length; // [ncurve]
    double *probe;  // [ncurve][CURVE_PROBES][2] points along it, equally spaced, both ends included
    int nnode, ntriangle, nsegment;
    double *xy;   // [nnode][2]; some belong to no triangle
    int *corner;  // [ntriangle][3]
    int *face;    // [ntriangle]
    int *segment; // [nsegment][2] nodes of element edges that follow curves
    int *curve;   // [nsegment]
} plane_pieces;

typedef struct plane_request plane_request;

struct plane_request {
    int nshape;
    bool *cuts;      // [nshape] the shape has no material
    int *loop_start; // [nshape + 1] into side_start; a shape's first loop is its outer one
    int *side_start; // [loops + 1] into side
    plane_side *side;
    double length; // target edge length
    double angle;  // largest arc of an edge [rad]
    int nsource;
    double *
        source; // [nsource][3] x, y and the edge length wanted there; it may grow with the distance
    const section_outline *drawn;           // for messages
    const section_outline *towards_corners; // NULL: edges do not become shorter towards corners
    double shrink[3];                       // by how much, of the corner's kind (meshes/corner.h)
    const plane_pieces *known;              // faces and curves, for the questions below
    // Asked once before meshing, with faces and curves known; it keeps them in `known`. May refuse.
    status (*check)(plane_request *r, const plane_pieces *p);
    // Equal edges of a curve, 0 where `size_at` decides.
    int (*parts)(const plane_request *r, int curve);
    // gmsh's question for an edge length; `request` is the plane_request.
    double (*size_at)(int dim, int tag, double x, double y, double z, void *request);
};

// Symbol "gmsh_door_mesh" of the module; to be called once in a process. ERR_NUMERIC with gmsh's
// words where it gave up. The caller frees what is in *out, also after a failure.
typedef status (*gmsh_door_mesh_function)(plane_request *request, plane_pieces *out);
status gmsh_door_mesh(plane_request *request, plane_pieces *out);
