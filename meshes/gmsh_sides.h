// meshes/gmsh_sides.h
// Within the gmsh module: shapes handed over, and gmsh's errors as ours.
#pragma once

#include "meshes/gmsh_door.h"

status gmsh_fail(const char *call);

// the call's last argument is the error code `ierr`
#define GMSH_TRY(call)                                                                             \
    do {                                                                                           \
        int ierr = 0;                                                                              \
        call;                                                                                      \
        if (ierr) {                                                                                \
            TRY(gmsh_fail(#call));                                                                 \
        }                                                                                          \
    } while (0)

// The face of a shape; *face is its tag.
status gmsh_add_shape(const plane_request *r, int shape, int *face);
