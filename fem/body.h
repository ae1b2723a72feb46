// fem/body.h
// A body: the elements of a plane mesh, layer upon layer along s. Node = plane node + nplane level;
// element = plane element of one layer. A prism, or a mesh whose nodes lie elsewhere at every level
// (turned, tapered, bent), or a stack in which each layer has its own matter. docs/theory.md (5.1)
//
// Every rank has the plane mesh; what is as large as the body it has for its own levels only.
#pragma once

#include "base/dense.h"
#include "base/material.h"
#include "base/mesh.h"
#include "base/status.h"

// Where the nodes of a level are.
typedef struct body_shape {
    const void *self;
    // Places of the plane mesh's nodes at arclength s in the base's axes [nnode][3] [m], and there
    // the pose of the section: axes as columns, origin [m]. From several ranks or threads at once.
    status (*place)(const void *self, double s, double *xyz, mat3 *axes, double origin[3]);
    // The plane mesh's frame `index` at s, in those axes; NULL: as the mesh has it, everywhere.
    status (*frame)(const void *self, double s, int index, material_frame *out);
} body_shape;

typedef struct body_spec {
    const mesh *plane; // borrowed; its z is 0
    const material *materials;
    int order;           // along s, 1..ELEMENT_MAX_ORDER; the plane mesh has its own
    int nlayer;          // 1 or more
    const double *layer; // [nlayer + 1] s where layers begin and end, ascending [m]
    body_shape shape;    // place NULL: a prism along z
    double turn_rate;    // without a shape: a prism that turns about z at this rate, by 0 at s = 0
                         // [rad/m]
    // [nlayer][elements of the plane mesh, block after block] material, -1: nothing there; NULL:
    // the plane mesh's own in every layer. Borrowed.
    const int *matter;
    int hold_first, hold_last; // levels to place, as in body_hold; hold_last 0: all of them
    bool
        mixed; // the volume's change is projected on a lower order (B-bar): no locking as nu -> 1/2
} body_spec;

typedef struct body {
    body_spec spec; // as given, but for `layer`
    const mesh *plane;
    int order, nlayer, nlevel; // nlevel = nlayer order + 1
    double *level;             // [nlevel] s, Gauss-Lobatto points within each layer [m]
    double length, radius;     // of the plane mesh about the origin [m]
    bool prism;                // neither shape nor turn
    element line;
    basis_table line_table;                   // rule along a layer
    basis_table plane_table[MESH_MAX_BLOCKS]; // rule in the plane, one per block
    int first, last;     // levels held: first <= level < last; all of them until body_hold
    double *node;        // [last - first][nplane][3] places of their nodes [m]; NULL for a prism
    mat3 *axes;          // [last - first] of the section; NULL for a prism
    double (*origin)[3]; // [last - first]; NULL for a prism
    int *touch_start;    // [nplane + 1] into touch; NULL without spec.matter
    int *touch;          // elements of the plane mesh, block after block, that a node belongs to
} body;

// ERR_INPUT where a layer is inverted or has no height; ERR_BUG where the plane mesh is none.
status body_make(const body_spec *spec, body *out);
void body_free(body *b);

// Keeps the levels from first to last - 1 only, all of which must be held: one rank's share, its
// neighbours' levels among them. Who never has room for all says so in the spec.
status body_hold(body *b, int first, int last);

// Place of a node of a level that is held.
static inline void body_node(const body *b, int plane_node, int level, double *xyz)
{
    const double *from = b->node
                             ? b->node + 3 * ((size_t)(level - b->first) * (size_t)b->plane->nnode +
                                              (size_t)plane_node)
                             : b->plane->xyz + 3 * (size_t)plane_node;
    xyz[0] = from[0];
    xyz[1] = from[1];
    xyz[2] = b->node ? from[2] : b->level[level];
}

// The pose of the section at a level that is held: of a prism the base's axes, and (0, 0, s).
mat3 body_axes(const body *b, int level);
void body_origin(const body *b, int level, double origin[3]);

// Material of plane element e of a block in a layer, -1: nothing there.
int body_material(const body *b, int block, int e, int layer);

// Whether a node belongs to any matter; all of them unless the spec has `matter`.
bool body_node_is_used(const body *b, int plane_node, int level);

// The section's pose inside a layer whose levels are held, at the line's reference coordinate:
// between the levels axes and origin are interpolated, the axes made orthonormal again. x and y of
// graded moduli and polar frames are the place along these axes from this origin.
void body_pose_at(const body *b, int layer, double at, mat3 *axes, double origin[3]);

static inline size_t body_node_count(const body *b)
{
    return (size_t)b->plane->nnode * (size_t)b->nlevel;
}
