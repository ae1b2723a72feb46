// meshes/free_child.h
// gmsh runs in a child process of its own: a crash, a hang or a word on the terminal of it stays
// there, and every mesh starts from the same state. The library is loaded once, before.
#pragma once

#include "meshes/gmsh_door.h"

// ERR_NUMERIC where gmsh crashed, ERR_RESOURCE where it took too long; else as gmsh_door_mesh.
status free_child_run(plane_request *request, plane_pieces *out);

void plane_pieces_free(plane_pieces *p);
