// section/stiffness.h
// The plane matrix E = int B^T Q B of (3.1), sparse, and its factors.
//
// Where no material couples the in-plane displacement with the one along z and nothing turns, these
// are two problems: the matrix has two parts, with unknowns (x, y of node 0, x, y of node 1, ...)
// and (z of node 0, ...), the nodes by rank. Else one part: (x, y, z of node 0, ...). The vectors
// of all parts follow one another.
#pragma once

#include "section/cholmod_door.h"
#include "section/kernel.h"
#include "section/plane.h"

#include <stdbool.h>

typedef struct stiffness_part {
    int first, width; // which components of a node's displacement
    int begin;        // of its unknowns among all 3 nnode
    sparse_lower E;   // (3.1), with the turning derivative of (3.9)
    sparse_lower P;   // (3.12), complex, the pattern borrowed from E; no values where nothing turns
} stiffness_part;

typedef struct stiffness {
    int nnode, npart;
    int *rank; // [nnode] number of a node in the order that fills the factors least
    stiffness_part part[2];
    sparse_lower graph; // of the nodes, no values
    int *where;         // [nnode] work: place of a row in the graph's column at hand
} stiffness;

static inline int stiffness_unknown(const stiffness *s, int node, int component)
{
    const stiffness_part *p = &s->part[s->npart == 2 && component == 2];
    return p->begin + p->width * s->rank[node] + component - p->first;
}

// values zero; split: two parts; turning: with P
status stiffness_make(const mesh *m, bool split, bool turning, stiffness *out);
void stiffness_free(stiffness *s);

// Adds one element's blocks.
void stiffness_add(stiffness *s, const plane_element *e, const element_blocks *blocks);

// Four unknowns that hold the section against the motions that do not strain it: three translations
// and the rotation about z. Their rows and columns become those of a diagonal matrix.
typedef struct stiffness_pins {
    int unknown[4];
} stiffness_pins;

stiffness_pins stiffness_choose_pins(const stiffness *s, const plane *p);
void stiffness_pin(stiffness *s, const stiffness_pins *pins);

// Factors of E, or of P.
typedef struct stiffness_factor {
    int npart, nunknown;
    bool wave;
    cholesky *part[2];
    int begin[2];
} stiffness_factor;

status stiffness_factor_make(const stiffness *s, bool wave, stiffness_factor *out);
void stiffness_factor_free(stiffness_factor *f);

// x = E^-1 b for nrhs columns, both [nrhs][3 nnode], of pairs for P; they may be the same.
status stiffness_solve(const stiffness_factor *f, int nrhs, const double *b, double *x);
