// meshes/dxf.h
// Drawings in ASCII DXF: lines, arcs, circles, ellipses, polylines with bulge and splines, read by
// ourselves; layers are the materials.
#pragma once

#include "base/input_file.h"
#include "meshes/parts.h"
#include "meshes/shape.h"

// One entity's curves, in the file's own unit.
typedef struct dxf_chain {
    int layer;
    long line;        // of the entity in the file
    int first, count; // into dxf_plan.piece
} dxf_chain;

typedef struct dxf_plan {
    int nlayer, layer_room;
    char (*layer)[64];
    int nchain, chain_room;
    dxf_chain *chain;
    int npiece, piece_room;
    carrier *piece;
    double unit; // of the file's lengths by its header [m]; 0: it does not say
    double size; // largest extent of the drawing
} dxf_plan;

// ERR_FILE where the file is damaged, or holds what has no outline here: blocks, solids, rational
// splines.
status dxf_read(const input_file *f, dxf_plan *out);
void dxf_plan_free(dxf_plan *p);

// What dxf_read and dxf_spline.c add to.
status dxf_add_chain(const input_file *f, dxf_plan *p, const char *layer, long line);
status dxf_add_piece(const input_file *f, dxf_plan *p, carrier c); // to the last chain

// Chains joined by their ends into closed loops of one layer.
typedef struct dxf_loop {
    int layer;
    int n;
    carrier *piece; // [n]
    long *line;     // [n] of the piece's entity
    double area;    // > 0: it runs counter-clockwise
} dxf_loop;

typedef struct dxf_loops {
    int count;
    dxf_loop *loop;
} dxf_loops;

// ERR_FILE, with the place, for open ends, branches, curves drawn twice, and loops that cross or
// touch themselves or others of their layer.
status dxf_join(const input_file *f, const dxf_plan *p, dxf_loops *out);
void dxf_loops_free(dxf_loops *l);

// Loops -> outlines [m]: in a layer a loop within a loop is a hole; of different layers the smaller
// lies on top. material: [layers], -1 cuts.
status dxf_nest(const dxf_plan *p, const dxf_loops *l, const int *material, double unit, mark at,
                section_outline *out);
