// meshes/msh.h
// Our own reader of gmsh's MSH files, versions 2.2 and 4.1, text or binary: gmsh itself would run
// what it finds in one.
//
// Triangles and quadrangles of order 1 to 4 are read (8-node quadrangles get their middle node);
// points and lines are passed over. An element's part is its physical group of dimension 2, by
// name, or by number where it has no name. Directions of materials come as $ElementData:
//   "plane_angle_deg" or "_rad", "fibre_angle_deg" or "_rad"   one value, as material_frame_make
//   "axes"                                                     nine: directions 1, 2, 3
// Elements without a value have the section's own directions; other views are passed over.
#pragma once

#include "meshes/parts.h"
#include "meshes/raw_mesh.h"

// `parts` says what is of which material; nodes in the file's unit, times `unit` metres.
// ERR_FILE with the line, or the byte of a binary file; ERR_INPUT where `parts` names what is not
// in the file.
status msh_read(const input_file *file, part_table *parts, double unit, raw_mesh *out);
