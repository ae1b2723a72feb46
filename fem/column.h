// fem/column.h
// A column: a plane mesh repeated along z. Its stiffness is a tensor product, so each plane element
// is integrated once for all layers. docs/theory.md (5.1).
#pragma once

#include "base/material.h"
#include "base/mesh.h"
#include "base/status.h"

typedef struct column {
    const mesh *plane;
    const material *materials;
    int order;          // along z, 1..4; the plane mesh has its own
    int nlayer, nlevel; // nlevel = nlayer order + 1
    double *level;      // [nlevel] z [m], Gauss-Lobatto points within each layer
    double length;      // [m]
    double radius;      // of the section about the origin [m]
    element line;
    basis_table table[MESH_MAX_BLOCKS]; // one per block of the plane mesh
} column;

// ERR_BUG where the levels are not those of whole layers of the order given, ERR_INPUT for
// materials that the segment does not take. Borrows plane and materials.
status column_make(const mesh *plane, const material *materials, int order, int nlevel,
                   const double *level, column *out);
void column_free(column *c);

// Of the circle about the origin that holds the section [m].
double column_section_radius(const mesh *plane);

// The same column with elements of a lower order in the plane and along z. *plane is the caller's
// to free after the column.
status column_lower(const column *c, int order, mesh *plane, column *out);

static inline size_t column_node_count(const column *c)
{
    return (size_t)c->plane->nnode * (size_t)c->nlevel;
}

// Matrices of one plane element, dofs 3 node + direction, by rows [3n][3n]:
//   E = int B^T Q B    C = int B^T Q S N    M = int (SN)^T Q S N = mass x diag(mu, mu, lambda + 2
//   mu)
enum { PLANE_DOFS = 3 * ELEMENT_MAX_PLANE_NODES };

typedef struct plane_matrices {
    int nnode;
    double lambda, mu; // [Pa]
    double E[PLANE_DOFS * PLANE_DOFS];
    double C[PLANE_DOFS * PLANE_DOFS];
    double mass[ELEMENT_MAX_PLANE_NODES * ELEMENT_MAX_PLANE_NODES]; // int N N^T [m^2]
} plane_matrices;

// ERR_NUMERIC where the element is inverted.
status plane_matrices_make(const column *c, int block, int element, plane_matrices *out);

// int N N^T, int N N'^T, int N' N'^T over a part of one layer.
typedef struct line_matrices {
    double M[ELEMENT_MAX_ORDER + 1][ELEMENT_MAX_ORDER + 1];
    double G[ELEMENT_MAX_ORDER + 1][ELEMENT_MAX_ORDER + 1];
    double K[ELEMENT_MAX_ORDER + 1][ELEMENT_MAX_ORDER + 1];
} line_matrices;

// z from `from` to `to`, clipped to the layer; zeroes where nothing is left.
line_matrices line_matrices_make(const column *c, int layer, double from, double to);

// K = E x M + C x G + C^T x G^T + M x K, by rows, dofs 3 (node + nnode level) + direction.
// docs/theory.md (5.1)
void element_stiffness(const plane_matrices *p, const line_matrices *line, int order, double *K);
