// base/element.h
// Reference elements of order 1 to 4 with Lagrange bases on nodes that are Gauss-Lobatto points
// along every edge.
//
//   line [-1,1]; triangle (0,0) (1,0) (0,1); quad [-1,1]^2; prism triangle x [-1,1]; hex [-1,1]^3
//
// Node order is the lattice's, first coordinate fastest: quad i + (p+1) j; triangle row j = 0..p
// holds i = 0..p-j; prism and hex: (node of the plane face) + (nodes of a plane face) * k. So an
// extruded mesh needs no permutation.
#pragma once

#include "base/status.h"

typedef enum shape { SHAPE_LINE, SHAPE_TRIANGLE, SHAPE_QUAD, SHAPE_PRISM, SHAPE_HEX } shape;

enum { ELEMENT_MAX_ORDER = 4, ELEMENT_MAX_NODES = 125, ELEMENT_MAX_PLANE_NODES = 25 };

typedef struct element {
    shape shape;
    int order, dim, nnode;
    double node[ELEMENT_MAX_NODES][3]; // reference coordinates
    // line: Lagrange denominators; triangle: Bernstein coefficients of each basis function
    double line_node[ELEMENT_MAX_ORDER + 1];
    double bernstein[15][15];
} element;

// order 1..4, else ERR_BUG. About 10 us; make it once per mesh.
status element_make(shape shape, int order, element *out);

int element_node_count(shape shape, int order);
int element_dim(shape shape);
const char *shape_name(shape shape);

// N [nnode] and dN [nnode][dim] (row per node) at the reference point x[dim]; dN may be NULL.
void element_basis(const element *e, const double *x, double *N, double *dN);

// Values at all points of a quadrature rule, made once and used for every element of a mesh.
typedef struct basis_table {
    int dim, nnode, npoint;
    double *weight; // [npoint]
    double *point;  // [npoint][dim]
    double *N;      // [npoint][nnode]
    double *dN;     // [npoint][nnode][dim]
} basis_table;

// A rule exact for polynomials of total degree `degree` (per direction on quads and hexes); degree
// <= 40.
status basis_table_make(const element *e, int degree, basis_table *out);
void basis_table_free(basis_table *table);

// Gauss-Legendre on [-1,1], n = 1..32 points; exact to degree 2n-1.
void gauss_legendre(int n, double *x, double *w);
// Gauss-Lobatto nodes on [-1,1], n = 2..9, ends included.
void gauss_lobatto_nodes(int n, double *x);
