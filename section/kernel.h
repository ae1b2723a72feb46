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

// [nnode * nnode] 3x3 blocks by rows, i nnode + j with i >= j: rows belong to node i, columns to
// node j
typedef struct element_blocks {
    double E[ELEMENT_MAX_PLANE_NODES * ELEMENT_MAX_PLANE_NODES][9];
    // P = E + wave[0] + i wave[1], of a field that varies as exp(i k z); only where k != 0
    double wave[2][ELEMENT_MAX_PLANE_NODES * ELEMENT_MAX_PLANE_NODES][9];
} element_blocks;

// `blocks` is overwritten, for i >= j.
void kernel_blocks(const matter *m, const plane *p, const plane_element *e, matter_element *at,
                   const channel_strains *s, element_blocks *blocks);
