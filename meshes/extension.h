// meshes/extension.h
// Displacements given at some nodes of a plane mesh, spread smoothly over the others: harmonic, on
// triangles that are the stiffer the smaller they are.
#pragma once

#include "base/status.h"

#include <stdbool.h>
#include <stddef.h>

typedef struct extension {
    int nnode, ntriangle, nfree;
    int (*triangle)[3];  // [ntriangle] nodes, counter-clockwise; taken over
    double (*weight)[3]; // [ntriangle] of the side across from each corner
    int *row;            // [nnode] of a free node, -1: given
    int *first;          // [nfree] column of a row's first entry
    size_t *start;       // [nfree] of a row in `factor`
    double *factor;      // Cholesky factor within its envelope, row by row
} extension;

// xyz [nnode][3]. given [nnode]. The triangles become the extension's, also where it fails.
status extension_make(int nnode, const double *xyz, int ntriangle, int (*triangle)[3],
                      const bool *given, extension *out);
void extension_free(extension *e);

// d [nnode][2]: fills what is not given. room [nfree].
void extension_fill(const extension *e, double (*d)[2], double *room);
