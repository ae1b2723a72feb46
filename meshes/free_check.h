// meshes/free_check.h
// What gmsh answered, checked: it may return success for nonsense.
#pragma once

#include "meshes/curved.h"

// ERR_NUMERIC where there are no triangles, or where they name nodes that are not there.
status pieces_check_indices(const plane_pieces *p);

// Faces seen from below are turned over, as a whole: an element inverted within its face still
// shows.
status pieces_turn_faces(plane_pieces *p);

// unfilled: [nface] faces whose triangles do not add up to their exact area; *count of them.
status pieces_find_unfilled(const plane_pieces *p, const curved_sides *s, bool *unfilled,
                            int *count);

// ERR_NUMERIC where the owner by gmsh's books is not the shape on top.
status pieces_check_owners(const plane_pieces *p, const curved_sides *s, const section_outline *o);
