// meshes/morph.h
// A plane mesh that follows along the rod the outlines that it was made of: the same elements, with
// borders and interfaces on the moved ones. docs/theory.md (5.16)
#pragma once

#include "base/mesh.h"
#include "meshes/shape.h"

typedef struct mesh_morph mesh_morph;

// Finds how the nodes of `plane`, a mesh of `base` at arclength s, hang on its outlines: by their
// places in the cells of the one grid (quads), or on the curves (triangles).
status mesh_morph_make(const section_outline *base, double s, const mesh *plane, mesh_morph **out);
void mesh_morph_free(mesh_morph *m); // NULL is nothing

// Whether the nodes keep their parts of a grid's cells, so that distance from the base does no
// harm.
bool mesh_morph_is_mapped(const mesh_morph *m);
// Whether outlines lie on grids of the same cells.
status outlines_share_grid(const section_outline *a, const section_outline *b, bool *share);

// xyz [nnode][3]: the nodes on the outlines `o` at arclength s, z = 0. turn: of the whole pattern
// since the base where all of it turns alike, else 0 [rad]. ERR_INPUT where shapes meet or part
// otherwise than at the base, or where elements would be turned inside out. *strain: how far the
// area of a triangle of nodes is at most changed beside what all of them are, |ln| of the ratio;
// 0 on a grid.
status mesh_morph_nodes(const mesh_morph *m, const section_outline *o, double s, double turn,
                        double *xyz, double *strain);
