// fem/brick.h
// One element of a body, a hexahedron or a prism: stiffness, forces, strains and stresses.
// docs/theory.md (5.1), (5.10)
#pragma once

#include "fem/body.h"

enum {
    BRICK_MAX_NODES = ELEMENT_MAX_PLANE_NODES * (ELEMENT_MAX_ORDER + 1),
    BRICK_MAX_DOFS = 3 * BRICK_MAX_NODES
};

// Works on all elements that stand on one plane element: what they share is worked out once. Any
// material of the section room: isotropic, orthotropic, anisotropic, with frames, graded over the
// place and along the rod.
typedef struct brick brick;

status brick_make(const body *b, brick **out); // working storage for one thread
void brick_free(brick *w);                     // NULL is nothing

// Plane element e of a block.
status brick_stand_on(brick *w, int block, int e);

// Dofs 3 (node of the plane element + per_elem k) + direction, k = 0..order the level in the layer;
// K [3n][3n] by rows, n = per_elem (order + 1), in the base's axes. The layer's levels must be
// held. ERR_NUMERIC where det J <= 0 (with the element's place), ERR_INPUT where a graded modulus
// is not positive. A layer without matter there gives zeroes.
status brick_stiffness(brick *w, int layer, double *K);

// Forces of the element's nodes for a force per volume [N/m^3], added to f [3n].
status brick_body_force(brick *w, int layer, const double force[3], double *f);
// int N dV of every node [n] times the density of its material [kg]: for gravity.
status brick_mass(brick *w, int layer, double *mass);

// Strain (xx yy zz yz xz xy, engineering shears) and stress [Pa] in the section's axes there, at
// the point (a, b) of the plane element's and c of the line's reference coordinates; u [3n]. With
// `mixed` stresses are of the projected strain. place may be NULL.
status brick_stress_at(brick *w, int layer, const double at[3], const double *u, double *strain,
                       double *stress, double *place);

// The points at which stresses of an element of these orders are most accurate: Gauss points, one
// fewer per direction than nodes. point [][3]; returns how many, at most BRICK_MAX_NODES.
int brick_best_points(const brick *w, double (*point)[3]);
