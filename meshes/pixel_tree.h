// Squares of 1, 2, 4, ... pixels of one material that cover an image: a quadtree about the image's
// centre, neighbours differing by at most one level.
#pragma once

#include "meshes/pixel_image.h"

typedef struct pixel_tree {
    const pixel_image *image;
    int offset[2];        // column i lies at i + offset[0] of the tree's root, rows likewise
    unsigned char *level; // [n[1]][n[0]] of the square that a pixel belongs to: 2^level pixels wide
    int nleaf;
} pixel_tree;

typedef struct pixel_tree_rule {
    int top; // no square is larger than 2^top pixels
    int rim; // pixels around a square of more than one that are of its material too
} pixel_tree_rule;

// The image must outlive the tree.
status pixel_tree_make(const pixel_image *p, const pixel_tree_rule *rule, pixel_tree *out);
void pixel_tree_free(pixel_tree *t);

// Whether a square begins at this pixel, its lower left one; *size in pixels.
bool pixel_tree_leaf(const pixel_tree *t, int i, int j, int *size);

// Whether side k (below, right, above, left) of that square is met by smaller ones.
bool pixel_tree_split(const pixel_tree *t, int i, int j, int size, int k);
