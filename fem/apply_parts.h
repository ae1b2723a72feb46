// fem/apply_parts.h
// What the files of apply.h share.
#pragma once

#include "fem/apply.h"
#include "fem/brick_law.h"

enum { APPLY_MAX_LINE_POINTS = ELEMENT_MAX_ORDER + 2 };

// A point of an element of a body that is no prism.
typedef struct apply_point {
    double back[3][3]; // d(X, Y, s) / d(x, y, z), by the section's coordinates X, Y
    double dV;
} apply_point;

// All elements that stand on one plane element.
typedef struct apply_element {
    const int *conn;
    int n2, np;     // nodes and points of the plane element
    double *slopes; // [3][np][n2] dN/dX, dN/dY, N
    double *area;   // [np] dX dY
    brick_law law;
    bool along;         // grade and Q are [layer][nl][np], else [np]
    double *grade;      // factor on the law; NULL: 1
    mat6 *Q;            // in the base's axes, without the grade; NULL: isotropic
    apply_point *point; // [layer][nl][np]; NULL: a prism
} apply_element;

struct apply {
    const body *body;
    int first_layer, last_layer;
    int nl;                                                  // points along a layer
    double L[APPLY_MAX_LINE_POINTS][ELEMENT_MAX_ORDER + 1];  // basis along a layer
    double dL[APPLY_MAX_LINE_POINTS][ELEMENT_MAX_ORDER + 1]; // its slope, reference
    int nelem;
    apply_element *element; // [nelem]
    // working storage, for `room` columns
    int room, most_nodes, most_points;
    double *nodal;   // [n2][3][ncol]
    double *flat;    // [levels of a layer][3][np][3][ncol] slopes at the levels
    double *flat_to; // the same of forces
    double *solid;   // [nl][3][np][3][ncol] slopes at the points
};

// Slopes u_i,j at the points of one layer become stresses times volumes. `solid` as above.
void apply_stresses(const apply *a, const apply_element *e, int layer, int ncol, double *solid);
