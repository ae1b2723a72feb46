// meshes/gmsh_kit.h
// What the gmsh module's files share. gmsh's own header comes before it.
#pragma once

#include "meshes/cad_door.h"

#include <stddef.h>

// ERR_FILE, or ERR_RESOURCE where memory ran out, with gmsh's words.
status cad_gmsh_fail(const char *call);

// the call's last argument is the error code `ierr`
#define CAD_TRY(call)                                                                              \
    do {                                                                                           \
        int ierr = 0;                                                                              \
        call;                                                                                      \
        if (ierr) {                                                                                \
            TRY(cad_gmsh_fail(#call));                                                             \
        }                                                                                          \
    } while (0)

enum { CURVE = 1, FACE = 2, SOLID = 3 };

// STEP: faces of bodies in the cutting plane, with common edges where they touch. `out` has the
// bodies; *face: [*nface] gmsh's tags, *owner: [*nface] into out->body, the caller's to free.
status cad_cut_step(const cad_request *request, cad_pieces *out, int *nface, int **face,
                    int **owner);

// How finely these faces and their edges are divided.
status cad_set_sizes(const cad_request *request, int nface, const int *face);

// A place of the file, in the section's axes.
void cad_to_section(const cad_request *request, const double *x, double *out);

// out->exact: places on the curves; index: [nindex] nodes by gmsh's tags.
status cad_place_on_curves(const cad_request *request, const int *index, size_t nindex,
                           cad_pieces *out);
