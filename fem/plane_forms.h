// fem/plane_forms.h
// The plane matrices of (5.1) of every element of a body's plane mesh, at the middle of the body:
// E = int B^T Q B, C = int B^T Q S N, M = int (S N)^T Q S N. Where the sections turn, B has what
// the turning adds (3.9): then all holds in the axes that turn with them.
#pragma once

#include "fem/body.h"

typedef enum plane_form { FORM_E, FORM_C, FORM_M, FORMS } plane_form;

// Dofs are direction nplane + node.
typedef struct plane_forms {
    const mesh *plane;
    double *value;   // [FORMS][3 n2][3 n2] of every element, dofs direction n2 + node
    size_t *at;      // [elements] where an element's begin
    size_t elements; // of the plane mesh, block after block
} plane_forms;

status plane_forms_make(const body *b, plane_forms *out);
void plane_forms_free(plane_forms *f);

// Y [3 nplane][m] = A X, or A^T X.
status plane_forms_multiply(const plane_forms *f, plane_form which, bool transposed, int m,
                            const double *X, double *Y);

// The upper triangle, by rows, of a form within some directions: dof = (direction - from) nplane +
// node, from <= direction < to.
typedef struct plane_pattern {
    int from, to, ndof;
    int *start, *column; // [ndof + 1], [start[ndof]] ascending
} plane_pattern;

status plane_pattern_make(const plane_forms *f, int from, int to, plane_pattern *out);
void plane_pattern_free(plane_pattern *p);
void plane_pattern_values(const plane_pattern *p, const plane_forms *f, plane_form which,
                          double *value);
