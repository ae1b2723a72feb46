// fem/brick_parts.h
// What the files of brick.h share.
#pragma once

#include "fem/brick.h"
#include "fem/brick_law.h"

// place of the strain u_i,j + u_j,i in the order xx yy zz yz xz xy
static const int brick_strain[3][3] = {{0, 5, 4}, {5, 1, 3}, {4, 3, 2}};

enum { BRICK_PAIRS = 9, BRICK_PLANES = 4, BRICK_MAX_PRESSURES = 20 };

// Plane matrices of (5.1) for one material, [3 n2][3 n2] by rows, dofs 3 node + direction.
typedef struct brick_plane {
    int material; // -1: none yet
    double *E, *C, *Ct, *M;
} brick_plane;

// The projection of the volume's change: pressures are polynomials in coordinates that map the
// element's mean Jacobian to one.
typedef struct brick_projection {
    int count;
    int power[BRICK_MAX_PRESSURES][3];
    bool by_reference; // in reference coordinates instead: the element is bent too much
    mat3 to_local;     // [i][j] d local_j / d x_i
    double centre[3];
    double lower[BRICK_MAX_PRESSURES][BRICK_MAX_PRESSURES]; // Cholesky of their Gram matrix
    double *value;                                          // [nq][count] orthonormal polynomials
    double *P; // [count][3n] int phi div: columns (direction, node)
} brick_projection;

struct brick {
    const body *body;
    element plane; // of the block
    int block, e;  // block -1: none yet
    const int *conn;
    int n2, n;      // nodes of the plane element, of the whole
    int np, nl, nq; // points in the plane, along the layer, in all: q = plane point + np k
    double *weight; // [nq] of the reference element
    double *slope;  // [nq][3][n] reference slopes
    // of one layer
    int layer;                      // -1: none yet
    double *xyz;                    // [n][3]
    double *grad;                   // [nq][3][n] slopes in the base's axes
    double *dV;                     // [nq]
    bool placed;                    // `place` is of this layer
    double (*place)[3];             // [nq]
    double *grade;                  // [nq] factor on the law
    mat6 *stiffness;                // [nq] Q
    brick_plane flat[BRICK_PLANES]; // of the materials met last
    int oldest;                     // of them
    brick_projection projection;
    bool projected;            // `projection` is of this layer
    double *work, *more, *sum; // see brick_make for sizes
};

status brick_tables(brick *w); // reference tables of the block
// xyz, grad and dV of a layer, once. ERR_NUMERIC where det J <= 0.
status brick_geometry(brick *w, int layer);
void brick_places(brick *w); // place, of the layer at hand
// The same at a point: N [n] and its slopes [3][n] in the base's axes, det J.
double brick_point(const brick *w, const double at[3], double *N, double *slope);

// Arclength of a point of the line's reference element.
double brick_arclength(const brick *w, int layer, double at);

// K by plane matrices, of a prism with a law that is the same along s.
status brick_prism_stiffness(brick *w, int layer, int material, double *K);
// K by quadrature over the whole element.
status brick_full_stiffness(brick *w, int layer, int material, double *K);

// dxi_j / dx_i [i][j] by the mean Jacobian of the layer at hand; *ratio: its determinant over the
// mean one.
mat3 brick_mean_jacobian_inverse(const brick *w, double *ratio);
void brick_choose_pressures(brick *w); // which polynomials
// Of the layer whose geometry is at hand.
status brick_project(brick *w);
// Projected change of volume at a point of displacements u [3n], at the place x.
double brick_projected(const brick *w, const double at[3], const double x[3], const double *u);
// sum [3n][3n] in (direction, node) = scale sum + bulk int grade theta theta^T, theta projected.
void brick_add_bulk(brick *w, double bulk, double scale, double *sum);
// K += what (5.10) adds to int B^T Q B with the Q at hand.
void brick_add_projection(brick *w, double *K);
