// meshes/mesher.h
// Outlines -> a conforming plane mesh with one material per element; plane mesh -> extruded solid
// mesh.
#pragma once

#include "base/mesh.h"
#include "meshes/shape.h"

typedef enum mesh_kind {
    MESH_AUTO,   // mapped where the outlines allow it, else free
    MESH_MAPPED, // quads on a polar or Cartesian grid of the outlines' own edges; no library is
                 // started
    MESH_FREE,   // gmsh: curved triangles of any outlines
} mesh_kind;

typedef struct mesh_options {
    mark at;
    int kind;          // mesh_kind
    int order;         // 1..4
    double size;       // target edge length [m]; 0: chosen from the outlines
    bool order_chosen; // the case leaves the order to us: a tolerance may lower it
    // beside the keys, where size is 0:
    int layers;   // of ever smaller elements towards corners, more than the default
    double finer; // parts of a chosen edge length; 0 is 1
    // Layers of elements that shrink by SIZING_GROWTH towards all free edges and interfaces, where
    // a clamped end's singular lines are. All free edges begin with the same length, interfaces
    // with SIZING_INTERFACE of it: thick parts take more layers, and parts thinner than three times
    // that length none, but for one at the interfaces of grids. Elements elsewhere become as large
    // as smooth fields and arcs allow. 0: no such layers, and small elements towards corners
    // instead. Images do without.
    int edge_layers;
    double edge_first; // that length over the section's radius, whatever the number of layers comes
                       // to; 1 asks for the largest elements there are. 0: such that the thinnest
                       // part at a free edge takes edge_layers
} mesh_options;

extern const key_table mesh_keys; // `section.mesh`
mesh_options mesh_options_default(void);
// The order that is used where the case leaves it to us.
void mesh_options_resolve(mesh_options *options);

// ERR_INPUT: nothing left of the section, parts that do not touch, slivers thinner than 1e-5 of the
// section's size that overlaps leave, a mapped mesh asked for where there is none. The result has
// passed mesh_check.
status section_mesh_make(const section_outline *o, const mesh_options *options, mesh *out);

// Whether the outlines lie on one polar or Cartesian grid, so that section_mesh_make starts no
// library.
bool section_mesh_is_mapped(const section_outline *o);

typedef struct extrude_options {
    double length;  // [m]
    int order;      // along z; 0: the plane mesh's. Must equal it today (isotropic order)
    int layers;     // elements along z, >= 2
    double grading; // size of a middle layer over that of an end layer, >= 1, geometric towards
                    // both ends
} extrude_options;

// Quads to hexes, triangles to prisms: node = plane node + (plane nodes) * level, element = plane
// element + (plane elements) * layer within the block. *levels: [layers * order + 1] z of each
// level, the caller's to free; may be NULL.
status mesh_extrude(const mesh *plane, const extrude_options *options, mesh *out, double **levels);
