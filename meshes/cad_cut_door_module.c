// meshes/cad_cut_door_module.c
// Solid bodies of a STEP file, cut by a plane. Of the gmsh module.
#include "base/memory.h"

#include <gmshc.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "meshes/gmsh_kit.h"

// of the bodies' reach: a plane nearer to a face than this runs along it, and bodies whose common
// piece is no larger than its square only touch
static const double ALONG = 1e-6;

// --- bodies

// "Shapes/assembly/part": the last word is the body's own
static void take_name(const char *label, cad_body *b)
{
    const char *last = strrchr(label, '/');
    (void)snprintf(b->name, sizeof b->name, "%s", last ? last + 1 : label);
}

static status describe(int tag, int number, cad_body *b)
{
    status st = OK;
    char *label = NULL;
    int c[4] = {0};
    b->number = number;
    CAD_TRY(gmshModelGetEntityName(SOLID, tag, &label, &ierr));
    take_name(label ? label : "", b);
    CAD_TRY(gmshModelGetColor(SOLID, tag, &c[0], &c[1], &c[2], &c[3], &ierr));
    b->coloured = c[3] != 0; // what has no colour in the file is transparent
    for (int i = 0; i < 3; i++) {
        b->rgb[i] = (unsigned char)c[i];
    }

done:
    gmshFree(label);
    return st;
}

static const char *body_words(const cad_body *b, char words[CAD_NAME + 16])
{
    if (b->name[0]) {
        (void)snprintf(words, CAD_NAME + 16, "'%s'", b->name);
    } else {
        (void)snprintf(words, CAD_NAME + 16, "number %d", b->number);
    }
    return words;
}

typedef struct cut {
    const cad_request *r;
    int nsolid, *solid; // gmsh's tags
    cad_body *body;     // [nsolid]
    double reach;       // of everything from the plane's origin
    int plane;          // tag of a face that holds everything
    int nface;          // pieces of bodies in the plane
    int *face, *owner;  // their tags and bodies
} cut;

static status read_solids(cut *c)
{
    status st = OK;
    int *found = NULL;
    size_t n = 0;
    double low[3] = {0}, high[3] = {0};
    CAD_TRY(gmshModelAdd("section", &ierr));
    CAD_TRY(gmshModelOccImportShapes(c->r->path, &found, &n, 1, "step", &ierr));
    CAD_TRY(gmshModelOccSynchronize(&ierr));
    TRY(TAKE(c->solid, n / 2));
    TRY(TAKE(c->body, n / 2));
    for (size_t i = 0; i < n; i += 2) {
        if (found[i] == SOLID) {
            TRY(describe(found[i + 1], c->nsolid + 1, &c->body[c->nsolid]));
            c->solid[c->nsolid++] = found[i + 1];
        }
    }
    if (c->nsolid == 0) {
        TRY(status_fail(ERR_FILE, "it holds no solid body"));
    }
    CAD_TRY(gmshModelGetBoundingBox(-1, -1, &low[0], &low[1], &low[2], &high[0], &high[1], &high[2],
                                    &ierr));
    for (int i = 0; i < 3; i++) {
        const double far = fmax(fabs(low[i] - c->r->place[i]), fabs(high[i] - c->r->place[i]));
        c->reach = hypot(c->reach, far);
    }
    if (!(c->reach > 0 && c->reach < 1e9)) {
        TRY(status_fail(ERR_FILE,
                        "its bodies have no size, or lie too far from the plane's origin"));
    }

done:
    gmshFree(found);
    return st;
}

// --- the plane

// a face whose middle lies in the plane, and whose normal is the plane's
static status check_face(const cut *c, int body, int face)
{
    status st = OK;
    char *type = NULL, words[CAD_NAME + 16];
    double *low = NULL, *high = NULL, *x = NULL, *normal = NULL, off = 0, along = 0;
    size_t nlow = 0, nhigh = 0, nx = 0, nnormal = 0;
    CAD_TRY(gmshModelGetType(FACE, face, &type, &ierr));
    if (strcmp(type, "Plane") != 0) {
        goto done;
    }
    CAD_TRY(gmshModelGetParametrizationBounds(FACE, face, &low, &nlow, &high, &nhigh, &ierr));
    if (nlow != 2 || nhigh != 2) {
        goto done;
    }
    double middle[2] = {(low[0] + high[0]) / 2, (low[1] + high[1]) / 2};
    CAD_TRY(gmshModelGetValue(FACE, face, middle, 2, &x, &nx, &ierr));
    CAD_TRY(gmshModelGetNormal(face, middle, 2, &normal, &nnormal, &ierr));
    for (int i = 0; i < 3 && nx == 3 && nnormal == 3; i++) {
        off += (x[i] - c->r->place[i]) * c->r->turn[2][i];
        along += normal[i] * c->r->turn[2][i];
    }
    if (nx == 3 && fabs(off) <= ALONG * c->reach && fabs(along) >= 1 - ALONG) {
        TRY(status_fail(ERR_FILE,
                        "the cutting plane runs along a face of the body %s: move `origin` into "
                        "the body",
                        body_words(&c->body[body], words)));
    }

done:
    gmshFree(type);
    gmshFree(low);
    gmshFree(high);
    gmshFree(x);
    gmshFree(normal);
    return st;
}

static status check_faces(const cut *c)
{
    status st = OK;
    int *faces = NULL;
    size_t n = 0;
    for (int b = 0; b < c->nsolid; b++) {
        int solid[2] = {SOLID, c->solid[b]};
        CAD_TRY(gmshModelGetBoundary(solid, 2, &faces, &n, 0, 0, 0, &ierr));
        for (size_t i = 0; i < n; i += 2) {
            TRY(check_face(c, b, faces[i + 1]));
        }
        gmshFree(faces);
        faces = NULL;
    }

done:
    gmshFree(faces);
    return st;
}

static status make_plane(cut *c)
{
    status st = OK;
    const double corner[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    int point[4], line[4], loop = 0;
    for (int k = 0; k < 4; k++) {
        double x[3];
        for (int i = 0; i < 3; i++) {
            x[i] = c->r->place[i] +
                   1.5 * c->reach *
                       (corner[k][0] * c->r->turn[0][i] + corner[k][1] * c->r->turn[1][i]);
        }
        CAD_TRY(point[k] = gmshModelOccAddPoint(x[0], x[1], x[2], 0, -1, &ierr));
    }
    for (int k = 0; k < 4; k++) {
        CAD_TRY(line[k] = gmshModelOccAddLine(point[k], point[(k + 1) % 4], -1, &ierr));
    }
    CAD_TRY(loop = gmshModelOccAddCurveLoop(line, 4, -1, &ierr));
    CAD_TRY(c->plane = gmshModelOccAddPlaneSurface(&loop, 1, -1, &ierr));

done:
    return st;
}

// what boolean operations give back, to be freed
typedef struct shapes {
    int *all, **map;
    size_t nall, *nmap, nn;
} shapes;

static void shapes_free(shapes *s)
{
    for (size_t i = 0; i < s->nn; i++) {
        gmshFree(s->map[i]);
    }
    gmshFree(s->map);
    gmshFree(s->nmap);
    gmshFree(s->all);
    *s = (shapes){0};
}

static status add_piece(cut *c, int tag, int owner)
{
    int *more = realloc(c->face, 2 * (size_t)(c->nface + 1) * sizeof *more);
    c->face = more ? more : c->face;
    int *owners = realloc(c->owner, (size_t)(c->nface + 1) * sizeof *owners);
    c->owner = owners ? owners : c->owner;
    if (!more || !owners) {
        return status_fail(ERR_RESOURCE, "not enough memory");
    }
    c->face[2 * c->nface] = FACE;
    c->face[2 * c->nface + 1] = tag;
    c->owner[c->nface++] = owner;
    return OK;
}

static status cut_bodies(cut *c)
{
    status st = OK;
    shapes s = {0};
    int plane[2] = {FACE, c->plane};
    for (int b = 0; b < c->nsolid; b++) {
        int solid[2] = {SOLID, c->solid[b]};
        CAD_TRY(gmshModelOccIntersect(plane, 2, solid, 2, &s.all, &s.nall, &s.map, &s.nmap, &s.nn,
                                      -1, 0, 0, &ierr));
        for (size_t i = 0; i < s.nall; i += 2) {
            if (s.all[i] == FACE) {
                TRY(add_piece(c, s.all[i + 1], b));
            }
        }
        shapes_free(&s);
    }
    if (c->nface == 0) {
        TRY(status_fail(ERR_FILE, "the cutting plane meets no body"));
    }
    for (int b = 0; b < c->nsolid; b++) {
        int solid[2] = {SOLID, c->solid[b]};
        CAD_TRY(gmshModelOccRemove(solid, 2, 1, &ierr));
    }
    CAD_TRY(gmshModelOccRemove(plane, 2, 1, &ierr));

done:
    shapes_free(&s);
    return st;
}

static status check_shared(const cut *c, int tag, int one, int two)
{
    status st = OK;
    double area = 0;
    char a[CAD_NAME + 16], b[CAD_NAME + 16];
    CAD_TRY(gmshModelOccGetMass(FACE, tag, &area, &ierr));
    if (area > ALONG * ALONG * c->reach * c->reach) {
        TRY(status_fail(ERR_FILE, "the bodies %s and %s overlap in the cutting plane",
                        body_words(&c->body[one], a), body_words(&c->body[two], b)));
    }

done:
    return st;
}

// Neighbours get common edges. Each input's fragments come back in turn; one that came before
// belongs to two bodies.
static status join_pieces(cut *c)
{
    status st = OK;
    shapes s = {0};
    const int n = c->nface;
    int *faces = c->face, *owner = c->owner;
    if (n == 1) {
        return OK;
    }
    c->face = c->owner = NULL;
    c->nface = 0;
    CAD_TRY(gmshModelOccFragment(faces, 2, faces + 2, 2 * (size_t)(n - 1), &s.all, &s.nall, &s.map,
                                 &s.nmap, &s.nn, -1, 1, 1, &ierr));
    for (int k = 0; k < n && (size_t)k < s.nn; k++) {
        for (size_t i = 0; i < s.nmap[k]; i += 2) {
            const int tag = s.map[k][i + 1];
            int before = 0;
            while (before < c->nface && c->face[2 * before + 1] != tag) {
                before++;
            }
            if (s.map[k][i] == FACE && before == c->nface) {
                TRY(add_piece(c, tag, owner[k]));
            } else if (s.map[k][i] == FACE && c->owner[before] != owner[k]) {
                TRY(check_shared(c, tag, c->owner[before], owner[k]));
            }
        }
    }

done:
    free(faces);
    free(owner);
    shapes_free(&s);
    return st;
}

// --- all of it

static status take_bodies(cut *c, cad_pieces *out)
{
    status st = OK;
    int *number = NULL;
    TRY(TAKE(number, (size_t)c->nsolid));
    TRY(TAKE(out->body, (size_t)c->nsolid));
    for (int k = 0; k < c->nface; k++) {
        int *of = &number[c->owner[k]];
        if (*of == 0) {
            out->body[out->nbody++] = c->body[c->owner[k]];
            *of = out->nbody;
        }
        c->owner[k] = *of - 1;
    }

done:
    free(number);
    return st;
}

status cad_cut_step(const cad_request *request, cad_pieces *out, int *nface, int **face,
                    int **owner)
{
    status st = OK;
    cut c = {.r = request};
    TRY(read_solids(&c));
    TRY(check_faces(&c));
    TRY(make_plane(&c));
    TRY(cut_bodies(&c));
    TRY(join_pieces(&c));
    CAD_TRY(gmshModelOccSynchronize(&ierr));
    TRY(take_bodies(&c, out));
    for (int k = 0; k < c.nface; k++) {
        c.face[k] = c.face[2 * k + 1]; // without gmsh's dimensions
    }
    *nface = c.nface;
    *face = c.face;
    *owner = c.owner;
    c.face = c.owner = NULL;

done:
    free(c.solid);
    free(c.body);
    free(c.face);
    free(c.owner);
    return st;
}
