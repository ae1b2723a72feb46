// section/estimate.h
// How far K on a mesh is from the truth, entry by entry, from lower orders of the mesh and from one
// with a layer less towards corners; and the mesh that meets a tolerance. docs/theory.md (3.8)
#pragma once

#include "base/beam_law.h"
#include "base/material.h"
#include "base/mesh.h"
#include "meshes/mesher.h"

// What is solved, as far as the estimate needs to know.
typedef struct mesh_solver {
    const void *what;
    // relative_error: of the rounding
    status (*solve)(const void *what, const mesh *m, beam_law *out);
    status (*mesh)(const void *what, const mesh_options *options, mesh *out);
    bool graded; // the mesh follows the options: elements can be smaller towards corners
    const material *materials; // NULL: what is solved has no corners
    bool turning;              // the pattern turns along the rod
} mesh_solver;

// K and its estimate on the mesh of the options.
status estimate_solve(const mesh_solver *s, const mesh_options *options, beam_law *out);

// The same on the coarsest mesh tried whose estimate is below the tolerance, by order (where
// free_order), edge lengths and layers at corners; *used: its options. ERR_NUMERIC, with what was
// reached, where none is.
status estimate_meet(const mesh_solver *s, const mesh_options *options, bool free_order,
                     double tolerance, beam_law *out, mesh_options *used);

// What a mesh of order p leaves behind next to corners that its elements do not shrink towards,
// from the differences d1 = |K_p - K_(p-1)| and d2 = |K_(p-1) - K_(p-2)|; d2 = 0 where p
// = 2.
double section_error_left(int p, double d1, double d2);
