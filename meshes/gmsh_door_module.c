// meshes/gmsh_door_module.c
// The one door to gmsh. It opens no file, so that gmsh never looks for something to run.
#include "meshes/gmsh_door.h"

#include "base/memory.h"
#include "meshes/gmsh_sides.h"

#include <gmshc.h>
#include <math.h>
#include <string.h>

enum { CURVE = 1, FACE };
enum { GMSH_LINE = 1, GMSH_TRIANGLE = 2 }; // gmsh's names of element types

status gmsh_fail(const char *call)
{
    char *words = NULL;
    int code = 0;
    gmshLoggerGetLastError(&words, &code);
    return status_fail(ERR_NUMERIC, "gmsh: %.300s, in %.60s", words ? words : "no message", call);
}

static status start(const plane_request *r)
{
    status st = OK;
    const struct {
        const char *name;
        double value;
    } options[] = {
        {"General.Terminal", 0},
        {"Mesh.Algorithm", 6}, // frontal Delaunay
        {"Mesh.MeshSizeFromPoints", 0},
        {"Mesh.MeshSizeMax", r->length},
    };
    char name[] = "stiffaxis", *arguments[] = {name, NULL};
    GMSH_TRY(gmshInitialize(1, arguments, 0, &ierr));
    for (size_t i = 0; i < sizeof options / sizeof *options; i++) {
        GMSH_TRY(gmshOptionSetNumber(options[i].name, options[i].value, &ierr));
    }
    GMSH_TRY(gmshModelAdd("section", &ierr));

done:
    return st;
}

// --- fragments

// *owner: [*nface] by gmsh's face tags, -1 where there is no such face
static status make_fragments(const plane_request *r, int **owner, int *nface)
{
    status st = OK;
    const int n = r->nshape;
    int *faces = NULL, *out = NULL, **map = NULL;
    size_t nout = 0, *nmap = NULL, nn = 0;

    TRY(TAKE(faces, 2 * (size_t)n));
    for (int k = 0; k < n; k++) {
        faces[2 * k] = FACE;
        TRY(gmsh_add_shape(r, k, &faces[2 * k + 1]));
    }
    // one shape is its own fragment
    if (n > 1) {
        GMSH_TRY(gmshModelOccFragment(faces, 2, faces + 2, 2 * (size_t)(n - 1), &out, &nout, &map,
                                      &nmap, &nn, -1, 1, 1, &ierr));
    }
    *nface = faces[1] + 1;
    for (size_t i = 0; i < nout; i += 2) {
        *nface = out[i + 1] >= *nface ? out[i + 1] + 1 : *nface;
    }
    TRY(TAKE(*owner, (size_t)*nface));
    memset(*owner, 0xff, (size_t)*nface * sizeof **owner);
    (*owner)[faces[1]] = n > 1 ? -1 : 0;
    // a later shape overwrites the owner of a face: it lies on top
    for (size_t k = 0; k < nn; k++) {
        for (size_t i = 0; i < nmap[k]; i += 2) {
            (*owner)[map[k][i + 1]] = (int)k;
        }
        gmshFree(map[k]);
    }

done:
    gmshFree(map);
    gmshFree(nmap);
    gmshFree(out);
    free(faces);
    return st;
}

// faces without material go; those that stay are numbered in the order of their tags
static status keep_faces(const plane_request *r, int *owner, int nface, plane_pieces *out,
                         int **tags)
{
    status st = OK;
    TRY(TAKE(*tags, (size_t)nface));
    TRY(TAKE(out->owner, (size_t)nface));
    TRY(TAKE(out->area, (size_t)nface));
    TRY(TAKE(out->around, (size_t)nface));
    for (int tag = 0; tag < nface; tag++) {
        int dim_tag[2] = {FACE, tag};
        if (owner[tag] >= 0 && r->cuts[owner[tag]]) {
            GMSH_TRY(gmshModelOccRemove(dim_tag, 2, 1, &ierr));
        } else if (owner[tag] >= 0) {
            GMSH_TRY(gmshModelOccGetMass(FACE, tag, &out->area[out->nface], &ierr));
            (*tags)[out->nface] = tag;
            out->owner[out->nface++] = owner[tag];
        }
    }
    if (out->nface == 0) {
        TRY(status_fail(ERR_INPUT, "the section is empty: what is drawn is cut away again"));
    }
    GMSH_TRY(gmshModelOccSynchronize(&ierr));

done:
    return st;
}

// --- curves

static status measure_curve(int tag, double *length, double *probe)
{
    status st = OK;
    double *low = NULL, *high = NULL, *xyz = NULL, at[CURVE_PROBES];
    size_t n = 0;

    GMSH_TRY(gmshModelGetParametrizationBounds(CURVE, tag, &low, &n, &high, &n, &ierr));
    for (int i = 0; i < CURVE_PROBES; i++) {
        at[i] = low[0] + (high[0] - low[0]) * i / (CURVE_PROBES - 1);
    }
    GMSH_TRY(gmshModelGetValue(CURVE, tag, at, CURVE_PROBES, &xyz, &n, &ierr));
    for (int i = 0; i < CURVE_PROBES; i++) {
        memcpy(probe + 2 * i, xyz + 3 * i, 2 * sizeof *xyz);
    }
    GMSH_TRY(gmshModelOccGetMass(CURVE, tag, length, &ierr));

done:
    gmshFree(low);
    gmshFree(high);
    gmshFree(xyz);
    return st;
}

static status measure_curves(plane_pieces *out)
{
    status st = OK;
    int *all = NULL;
    size_t n = 0;
    GMSH_TRY(gmshModelGetEntities(&all, &n, CURVE, &ierr));
    TRY(TAKE(out->tag, n));
    TRY(TAKE(out->length, n));
    TRY(TAKE(out->probe, n * CURVE_PROBES));
    out->ncurve = (int)(n / 2);
    for (int i = 0; i < out->ncurve; i++) {
        out->tag[i] = all[2 * i + 1];
        TRY(measure_curve(out->tag[i], &out->length[i], out->probe + 2 * CURVE_PROBES * i));
    }

done:
    gmshFree(all);
    return st;
}

static status measure_boundary(int face, const plane_pieces *p, double *around)
{
    status st = OK;
    int dim_tag[2] = {FACE, face}, *bound = NULL;
    size_t n = 0;
    GMSH_TRY(gmshModelGetBoundary(dim_tag, 2, &bound, &n, 0, 0, 0, &ierr));
    for (size_t i = 0; i < n; i += 2) {
        for (int k = 0; k < p->ncurve; k++) {
            *around += p->tag[k] == bound[i + 1] ? p->length[k] : 0;
        }
    }

done:
    gmshFree(bound);
    return st;
}

static status divide_curves(plane_request *r, const plane_pieces *p)
{
    status st = OK;
    TRY(r->check(r, p));
    for (int i = 0; i < p->ncurve; i++) {
        const int n = r->parts(r, i);
        if (n > 0) {
            GMSH_TRY(gmshModelMeshSetTransfiniteCurve(p->tag[i], n + 1, "Progression", 1, &ierr));
        }
    }
    if (r->nsource > 0) {
        GMSH_TRY(gmshModelMeshSetSizeCallback(r->size_at, r, &ierr));
    }

done:
    return st;
}

// --- mesh

// the nodes at the places of their tags; what no element uses stays 0
static status take_nodes(plane_pieces *out)
{
    status st = OK;
    size_t *tags = NULL, n = 0, nxyz = 0, nnone = 0;
    double *xyz = NULL, *none = NULL;
    GMSH_TRY(gmshModelMeshGetNodes(&tags, &n, &xyz, &nxyz, &none, &nnone, -1, -1, 0, 0, &ierr));
    for (size_t i = 0; i < n; i++) {
        out->nnode = (int)tags[i] >= out->nnode ? (int)tags[i] + 1 : out->nnode;
    }
    TRY(TAKE(out->xy, 2 * (size_t)out->nnode));
    for (size_t i = 0; i < n; i++) {
        memcpy(out->xy + 2 * tags[i], xyz + 3 * i, 2 * sizeof *xyz);
    }

done:
    gmshFree(tags);
    gmshFree(xyz);
    gmshFree(none);
    return st;
}

// elements of one type: the nodes of each in *conn, the index of its entity in *of
static status take_elements(int type, int nentity, const int *entity, int *count, int **conn,
                            int **of)
{
    status st = OK;
    const size_t per = type == GMSH_LINE ? 2 : 3;
    size_t *tags = NULL, n = 0, *nodes = NULL, nnode = 0, most = 0;
    // first all there are, for the room they take
    for (int k = -1; k < nentity; k++) {
        GMSH_TRY(gmshModelMeshGetElementsByType(type, &tags, &n, &nodes, &nnode,
                                                k < 0 ? -1 : entity[k], 0, 1, &ierr));
        if (k < 0) {
            most = n;
            TRY(TAKE(*conn, most * per));
            TRY(TAKE(*of, most));
        }
        for (size_t i = 0; k >= 0 && i < n && (size_t)*count < most; i++, ++*count) {
            (*of)[*count] = k;
            for (size_t j = 0; j < per; j++) {
                (*conn)[(size_t)*count * per + j] = (int)nodes[i * per + j];
            }
        }
        gmshFree(tags);
        gmshFree(nodes);
        tags = nodes = NULL;
    }

done:
    gmshFree(tags);
    gmshFree(nodes);
    return st;
}

status gmsh_door_mesh(plane_request *request, plane_pieces *out)
{
    status st = OK;
    int *owner = NULL, ntag = 0, *faces = NULL;

    *out = (plane_pieces){0};
    TRY(start(request));
    TRY(make_fragments(request, &owner, &ntag));
    TRY(keep_faces(request, owner, ntag, out, &faces));
    TRY(measure_curves(out));
    for (int k = 0; k < out->nface; k++) {
        TRY(measure_boundary(faces[k], out, &out->around[k]));
    }
    TRY(divide_curves(request, out));
    GMSH_TRY(gmshModelMeshGenerate(2, &ierr));
    TRY(take_nodes(out));
    TRY(take_elements(GMSH_TRIANGLE, out->nface, faces, &out->ntriangle, &out->corner, &out->face));
    TRY(take_elements(GMSH_LINE, out->ncurve, out->tag, &out->nsegment, &out->segment,
                      &out->curve));

done:
    free(owner);
    free(faces);
    return st;
}
