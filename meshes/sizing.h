// meshes/sizing.h
// How large elements are where the case does not say so, and at most.
#pragma once

#include "meshes/corner.h"
#include "meshes/mesher.h"

enum { SECTION_MOST_ELEMENTS = 200000 };

// Elements towards a corner shrink by this factor, layer by layer: those of order 3 and 4 follow a
// singular field over such steps as well as over smaller ones.
#define SIZING_GROWTH 5.0

// How many element edges take the place of one of the chosen length.
double sizing_finer(const mesh_options *options);

// By what elements grow away from corners; less where they are finer.
double sizing_growth(const mesh_options *options);

// Target edge length [m].
double sizing_length(const mesh_options *options, double section_size);

// Largest angle of an arc that one element edge follows [rad].
double sizing_angle(const mesh_options *options);

// Edge length next to a corner over that of the layer beyond which nothing shrinks: each layer
// takes SIZING_GROWTH.
double sizing_shrink(const mesh_options *options, corner c);

// By what the elements between edge layers may exceed the next layer's: fields there are smooth.
#define SIZING_STRETCH 3.0

// The first layer at an interface over that at a free edge. A clamped end is less singular there,
// but it is there, and at the largest stresses.
#define SIZING_INTERFACE 4.0

// With edge layers: length of the smallest elements [m], thinnest the section's thinnest part;
// largest length [m], and largest angle of an arc [rad].
double sizing_edge_first(const mesh_options *options, double section_size, double thinnest);
double sizing_edge_length(const mesh_options *options, double section_size);
double sizing_edge_angle(const mesh_options *options);
// As sizing_shrink, of triangles.
double sizing_edge_shrink(const mesh_options *options, corner c);

// How many equal parts of at most `target` make up `length`; at least one. Rounding does not add a
// part.
double sizing_parts(double length, double target);
