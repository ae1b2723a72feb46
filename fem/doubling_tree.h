// fem/doubling_tree.h
// One part of a prism's cuts: slabs joined with themselves until they are the body, the ends held
// and loaded, and the way back down to the cuts. docs/theory.md (5.12)
#pragma once

#include "fem/doubling_slab.h"
#include "fem/load.h"

// What joins two slabs to one: factors of the unknowns of the cut between them, even and odd, and
// the other cuts' forces on them.
typedef struct slab_joint {
    double *even, *odd;       // [neven][neven], [nodd][nodd] lower triangles
    double *to_even, *to_odd; // [n][neven], [n][nodd] by columns
} slab_joint;

typedef struct doubling_tree {
    const cut *cut;
    int part, doublings, grid;  // grid: how often the body is halved to its reported cuts
    double height, turn;        // of the thinnest slab
    slab_joint *joint;          // [doublings] from the thinnest slabs up; zero where forgotten
    slab_stiffness whole, cell; // of the body, of a slab between two reported cuts
} doubling_tree;

// Takes the slab's stiffness over. keep: joints below the reported cuts too, for fields.
status doubling_tree_make(const cut *c, int part, const slab *s, slab_stiffness *thin,
                          int doublings, int grid, bool keep, bool (*cancelled)(void),
                          doubling_tree *out);
void doubling_tree_free(doubling_tree *t);

// Displacements of the two ends, [ncolumn][n] each: forces on the tip's unknowns and, where the
// base is free to contract, on the base's.
status doubling_tree_ends(const doubling_tree *t, int base, int tip, int ncolumn,
                          const double *tip_force, const double *base_force, double *u0,
                          double *u1);

// Slabs of one height somewhere in the body. Their ends' unknowns are seen from the lower end: its
// rigid motion, `rigid`, is not in them.
typedef struct slab_list {
    int count, ncolumn, doublings; // of each slab
    int *start;                    // [count] lower end in thinnest slabs
    double *lower, *upper;         // [count][ncolumn][n]
    double *rigid; // [count][ncolumn][nrigid] of the lower end, in its section's axes
} slab_list;

// The whole body, its ends displaced.
status slab_list_whole(const doubling_tree *t, int ncolumn, const double *u0, const double *u1,
                       slab_list *out);
void slab_list_free(slab_list *list);

// Halves those slabs of the list within which there is a wanted cut (ascending, in thinnest slabs;
// NULL: all), and drops the others.
status slab_list_halve(const doubling_tree *t, int nwanted, const int *wanted, slab_list *list);

// The rigid motion q of a slab's lower end, seen at its upper end in the section's axes there.
void doubling_tree_carry(const doubling_tree *t, double height, double turn, const double *q,
                         double *at_top);

// Forces that the slabs of the grid feel at their ends, [count][ncolumn][n] each.
status doubling_tree_forces(const doubling_tree *t, const slab_list *cells, double *lower,
                            double *upper);
