// section/stiffness.h
// The plane matrix E = int B^T Q B of (3.1), sparse. Isotropic materials do not couple the in-plane
// displacement with the one along z, so the unknowns are ordered (x, y of node 0, x, y of node 1,
// ..., z of node 0, z of node 1, ...).
#pragma once

#include "section/cholmod_door.h"
#include "section/plane.h"

#include <stdbool.h>

// component 0, 1, 2 of a node's displacement among 3 * nnode unknowns
static inline int warping_unknown(int nnode, int node, int component)
{
    return component < 2 ? 2 * node + component : 2 * nnode + node;
}

// Which nodes share an element, as a lower triangle, and from it the pattern of E.
typedef struct stiffness {
    int nnode;
    sparse_lower graph;  // of the nodes, no values
    sparse_lower matrix; // of the unknowns
    int *where;          // [nnode] work: place of a row in the graph's column at hand
} stiffness;

status stiffness_make(const mesh *m, stiffness *out); // values zero
void stiffness_free(stiffness *s);

// Adds one element's int B^T Q B with Lame's lambda and the shear modulus G.
void stiffness_add(stiffness *s, const plane_element *e, double lambda, double G);

// Four unknowns that hold the section against the motions that do not strain it: three translations
// and the rotation about z. Their rows and columns become those of a diagonal matrix.
typedef struct stiffness_pins {
    int unknown[4];
} stiffness_pins;

stiffness_pins stiffness_choose_pins(const plane *p);
void stiffness_pin(stiffness *s, const stiffness_pins *pins);

// A fill-reducing order of the nodes, spread to their unknowns: permutation[new] = old, [3 nnode].
status stiffness_order(const stiffness *s, int *permutation);
