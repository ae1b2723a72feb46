// meshes/cad.h
// Files that gmsh reads, in a child process with limits: `step:` and `geo:`.
#pragma once

#include "meshes/cad_door.h"
#include "meshes/parts.h"

typedef struct cad_source {
    input_file file; // its bytes are what is read, whatever becomes of the file
    cad_request request;
    double unit; // of the request's lengths [m]
    int nbody;
    int *material; // [nbody]
} cad_source;

// Runs gmsh once to see what is there; s->file, s->request and s->unit are given. ERR_FILE where
// gmsh refuses the file or crashes on it, ERR_RESOURCE where it takes too long or too much.
status cad_look(cad_source *s, part_table *parts);

// The mesh of what the request says, with shorter edges where elements would be inverted.
status cad_mesh(const cad_source *s, const mesh_options *options, mesh *out);

void cad_source_free(cad_source *s);
