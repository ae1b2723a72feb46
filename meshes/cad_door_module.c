// meshes/cad_door_module.c
// gmsh's door for files that it reads itself. Runs in a child process with limits, see cad.c.
#include "meshes/cad_door.h"

#include "base/memory.h"

#include <gmshc.h>
#include <limits.h>
#include <stdio.h>
#include <string.h>

#include "meshes/gmsh_kit.h"

status cad_gmsh_fail(const char *call)
{
    char *words = NULL;
    int code = 0;
    gmshLoggerGetLastError(&words, &code);
    const bool memory = words && (strstr(words, "memory") || strstr(words, "alloc"));
    return status_fail(memory ? ERR_RESOURCE : ERR_FILE, "gmsh: %.200s, in %.30s",
                       words && words[0] ? words : "no message", call);
}

static status start(const cad_request *r)
{
    status st = OK;
    const struct {
        const char *name;
        double value;
    } options[] = {
        {"General.Terminal", 0},
        {"General.NumThreads", 1},
        {"Geometry.OCCImportLabels", 1},
        {"Mesh.Algorithm", 6}, // frontal Delaunay
        {"Mesh.MeshSizeFromPoints", r->script},
        {"Mesh.ElementOrder", r->order},
        {"Mesh.SecondOrderIncomplete", 0},
    };
    char name[] = "stiffaxis", *arguments[] = {name, NULL};
    CAD_TRY(gmshInitialize(1, arguments, 0, &ierr));
    for (size_t i = 0; i < sizeof options / sizeof *options; i++) {
        CAD_TRY(gmshOptionSetNumber(options[i].name, options[i].value, &ierr));
    }
    CAD_TRY(gmshOptionSetString("Geometry.OCCTargetUnit", "MM", &ierr));

done:
    return st;
}

// --- elements out

void cad_to_section(const cad_request *r, const double *x, double *out)
{
    for (int d = 0; d < 3; d++) {
        out[d] = 0;
        for (int k = 0; k < 3; k++) {
            out[d] += r->turn[d][k] * (x[k] - r->place[k]);
        }
    }
}

static status take_nodes(const cad_request *r, cad_pieces *out, int **index, size_t *nindex)
{
    status st = OK;
    size_t *tags = NULL, ntag = 0, nx = 0, nu = 0, largest = 0;
    double *x = NULL, *unused = NULL;
    CAD_TRY(gmshModelMeshGetNodes(&tags, &ntag, &x, &nx, &unused, &nu, -1, -1, 0, 0, &ierr));
    for (size_t i = 0; i < ntag; i++) {
        largest = tags[i] > largest ? tags[i] : largest;
    }
    if (ntag == 0 || nx != 3 * ntag || largest > 100 * ntag + 1000 || ntag > INT_MAX / 4) {
        TRY(status_fail(ERR_FILE, "gmsh gave no mesh"));
    }
    *nindex = largest + 1;
    TRY(TAKE(*index, *nindex));
    memset(*index, 0xff, *nindex * sizeof **index);
    TRY(TAKE(out->xyz, 3 * ntag));
    for (size_t i = 0; i < ntag; i++) {
        (*index)[tags[i]] = (int)i;
        cad_to_section(r, x + 3 * i, out->xyz + 3 * i);
    }
    out->nnode = (int)ntag;
    TRY(cad_place_on_curves(r, *index, *nindex, out));

done:
    gmshFree(tags);
    gmshFree(x);
    gmshFree(unused);
    return st;
}

static status take_more(void **items, size_t count, size_t each)
{
    void *more = realloc(*items, count * each);
    *items = more ? more : *items;
    return more ? OK : status_fail(ERR_RESOURCE, "not enough memory");
}

typedef struct element_list {
    int type;
    size_t count, nconn;
    const size_t *conn;
} element_list;

static status add_elements(const element_list *l, int body, const int *index, size_t nindex,
                           cad_pieces *out)
{
    status st = OK;
    char *name = NULL;
    int dim = 0, order = 0, per = 0, corners = 0;
    double *unused = NULL;
    size_t nu = 0;
    CAD_TRY(gmshModelMeshGetElementProperties(l->type, &name, &dim, &order, &per, &unused, &nu,
                                              &corners, &ierr));
    const size_t n = l->count, whole = (size_t)(corners == 3 ? (order + 1) * (order + 2) / 2
                                                             : (order + 1) * (order + 1));
    if (dim != FACE || (corners != 3 && corners != 4) || l->nconn != n * (size_t)per ||
        (size_t)per != whole || (out->order && out->order != order) || n > 100000000) {
        TRY(status_fail(ERR_FILE, "gmsh made elements that are not read: %.60s", name));
    }
    out->order = order;
    const size_t first = (size_t)out->nelem, from = (size_t)out->nconn;
    TRY(take_more((void **)&out->sides, first + n, sizeof *out->sides));
    TRY(take_more((void **)&out->body_of, first + n, sizeof *out->body_of));
    TRY(take_more((void **)&out->conn, from + l->nconn, sizeof *out->conn));
    for (size_t i = 0; i < n; i++) {
        out->sides[first + i] = corners;
        out->body_of[first + i] = body;
    }
    for (size_t i = 0; i < l->nconn; i++) {
        const size_t tag = l->conn[i];
        if (tag >= nindex || index[tag] < 0) {
            TRY(status_fail(ERR_FILE, "gmsh's elements make no sense"));
        }
        out->conn[from + i] = index[tag];
    }
    out->nelem += (int)n;
    out->nconn += (int)l->nconn;

done:
    gmshFree(name);
    gmshFree(unused);
    return st;
}

static status take_face(int face, int body, const int *index, size_t nindex, cad_pieces *out)
{
    status st = OK;
    int *types = NULL;
    size_t ntype = 0, **tags = NULL, *ntag = NULL, nn = 0, **conn = NULL, *nconn = NULL, nnn = 0;
    CAD_TRY(gmshModelMeshGetElements(&types, &ntype, &tags, &ntag, &nn, &conn, &nconn, &nnn, FACE,
                                     face, &ierr));
    for (size_t i = 0; i < ntype; i++) {
        if (ntag[i] > 0) {
            const element_list l = {
                .type = types[i], .count = ntag[i], .nconn = nconn[i], .conn = conn[i]};
            TRY(add_elements(&l, body, index, nindex, out));
        }
    }

done:
    for (size_t i = 0; i < nn; i++) {
        gmshFree(tags[i]);
    }
    for (size_t i = 0; i < nnn; i++) {
        gmshFree(conn[i]);
    }
    gmshFree(types);
    gmshFree(tags);
    gmshFree(ntag);
    gmshFree(conn);
    gmshFree(nconn);
    return st;
}

// --- a script

static status take_groups(cad_pieces *out, int **groups)
{
    status st = OK;
    char *name = NULL;
    size_t n = 0;
    CAD_TRY(gmshModelGetPhysicalGroups(groups, &n, FACE, &ierr));
    if (n == 0) {
        TRY(status_fail(ERR_FILE, "the script makes no physical surface: which material is what?"));
    }
    TRY(TAKE(out->body, n / 2));
    for (size_t i = 0; i < n; i += 2) {
        cad_body *b = &out->body[out->nbody++];
        b->number = (*groups)[i + 1];
        CAD_TRY(gmshModelGetPhysicalName(FACE, b->number, &name, &ierr));
        (void)snprintf(b->name, sizeof b->name, "%s", name ? name : "");
        gmshFree(name);
        name = NULL;
    }

done:
    gmshFree(name);
    return st;
}

// what the script did not mesh itself
static status mesh_script(const cad_request *r)
{
    status st = OK;
    int *types = NULL;
    size_t n = 0;
    CAD_TRY(gmshModelMeshGetElementTypes(&types, &n, FACE, -1, &ierr));
    if (r->length > 0) {
        CAD_TRY(gmshOptionSetNumber("Mesh.MeshSizeMax", r->length, &ierr));
    }
    if (n == 0 || r->length > 0) {
        CAD_TRY(gmshModelMeshClear(NULL, 0, &ierr));
        CAD_TRY(gmshModelMeshGenerate(FACE, &ierr));
    }
    CAD_TRY(gmshModelMeshSetOrder(r->order, &ierr));

done:
    gmshFree(types);
    return st;
}

static status run_script(const cad_request *r, cad_pieces *out)
{
    status st = OK;
    int *groups = NULL, *faces = NULL, *index = NULL;
    size_t n = 0, nindex = 0;
    CAD_TRY(gmshOptionSetNumber("General.AbortOnError", 2, &ierr));
    CAD_TRY(gmshOpen(r->path, &ierr));
    TRY(take_groups(out, &groups));
    TRY(mesh_script(r));
    TRY(take_nodes(r, out, &index, &nindex));
    for (int k = 0; k < out->nbody; k++) {
        CAD_TRY(gmshModelGetEntitiesForPhysicalGroup(FACE, out->body[k].number, &faces, &n, &ierr));
        for (size_t i = 0; i < n; i++) {
            TRY(take_face(faces[i] < 0 ? -faces[i] : faces[i], k, index, nindex, out));
        }
        gmshFree(faces);
        faces = NULL;
    }

done:
    gmshFree(groups);
    gmshFree(faces);
    free(index);
    return st;
}

// --- a STEP file

static status mesh_step(const cad_request *r, cad_pieces *out)
{
    status st = OK;
    int nface = 0, *face = NULL, *owner = NULL, *index = NULL;
    size_t nindex = 0;
    TRY(cad_cut_step(r, out, &nface, &face, &owner));
    if (r->look) {
        goto done;
    }
    TRY(cad_set_sizes(r, nface, face));
    CAD_TRY(gmshModelMeshGenerate(FACE, &ierr));
    TRY(take_nodes(r, out, &index, &nindex));
    for (int k = 0; k < nface; k++) {
        TRY(take_face(face[k], owner[k], index, nindex, out));
    }

done:
    free(face);
    free(owner);
    free(index);
    return st;
}

status gmsh_door_cad(const cad_request *request, cad_pieces *out)
{
    status st = OK;
    *out = (cad_pieces){0};
    TRY(start(request));
    TRY(request->script ? run_script(request, out) : mesh_step(request, out));

done:
    return st;
}
