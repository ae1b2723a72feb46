// section/fields.h
// Strains and stresses of a section under six unit end wrenches, and from them under any wrench.
// docs/theory.md (3.20), (3.21)
#pragma once

#include "section/matter.h"
#include "section/section.h"

// Strains at a point of an element for the six unit wrenches, column by column [1/N, 1/(N m)].
// `length` and `centre` of the plane bring its scaled coordinates back.
mat6 section_strains(const plane *p, const plane_element *e, int point,
                     const section_warping *warping, double turn_rate);

// Q at a point of an element, grading included [Pa]. `frame`: -1, or index into the mesh's frames.
mat6 section_stress_law(const mesh *m, const material *materials, int material, int frame, double x,
                        double y);
// Young's modulus along z there, 1 / (Q^-1)_zz [Pa]
double section_axial_modulus(const mesh *m, const material *materials, int material, int frame,
                             double x, double y);
// The frame of an element; -1: the section's own axes.
int section_frame_of(const mesh_block *b, int element);

// The fields at the nodes. A node where materials or their directions meet is there once for each,
// so that every field is continuous within one material.
typedef struct section_fields {
    mesh mesh;     // the section's, its nodes apart
    int *material; // [nnode]
    int *frame;    // [nnode] index into mesh.frame, -1: the section's axes
    mat6 *strain;  // [nnode] column j for unit wrench j, at the section's origin; mean over the
                   // node's elements
} section_fields;

status section_fields_make(const mesh *m, const section_warping *warping, double turn_rate,
                           section_fields *out);

// The classical model's: strains of (2.1) from K, and sideways as a fibre that is free there.
status section_fields_classical(const mesh *m, const material *materials, const mat6 *K,
                                section_fields *out);
void section_fields_free(section_fields *f);

vec6 section_strain_at(const section_fields *f, int node, const vec6 *wrench);
vec6 section_stress_at(const section_fields *f, const material *materials, int node,
                       const vec6 *strain); // [Pa]

// Of largest magnitude, with its sign.
double principal_strain(const vec6 *strain);
double von_mises(const vec6 *stress);
