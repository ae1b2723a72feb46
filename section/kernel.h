// section/kernel.h
// One element's share of the plane matrices of (3.1) and (3.9), node by node.
//
// A node's strains are a sum over four channels: N, dN/dx, dN/dy and the turning derivative
// y dN/dx - x dN/dy, each with a constant 6x3 matrix. So the integrals are those of the products of
// channels, and the material comes in once per element.
#pragma once

#include "section/matter.h"

enum { ALONG_X, ALONG_Y, VALUE, TURNING, CHANNELS };

// Strains of a unit displacement in each channel, where the pattern turns at rate k
typedef struct channel_strains {
    int count; // of channels in use: two where k = 0
    double a[CHANNELS][6][3];
} channel_strains;

channel_strains channel_strains_make(double k);

// Entries [3 row + column] of the nodes' 3x3 blocks, each [nnode * nnode] at i nnode + j: rows
// belong to node i, columns to node j.
typedef double node_pairs[ELEMENT_MAX_PLANE_NODES * ELEMENT_MAX_PLANE_NODES];

typedef struct element_blocks {
    node_pairs E[9];
    // P = E + wave[0] + i wave[1], of a field that varies as exp(i k z); only where k != 0
    node_pairs wave[2][9];
} element_blocks;

// `blocks` is overwritten.
void kernel_blocks(const matter *m, const plane *p, const plane_element *e, matter_element *at,
                   const channel_strains *s, element_blocks *blocks);
