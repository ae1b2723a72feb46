// meshes/free.c
#include "meshes/free.h"

#include "base/memory.h"
#include "meshes/curved.h"
#include "meshes/free_child.h"
#include "meshes/outline.h"
#include "meshes/plane_shapes.h"
#include "meshes/plane_sizing.h"
#include "meshes/sizing.h"

#include <math.h>
#include <stdlib.h>

// An element's det J may fall to this part of its mean. Below, the curves are divided more finely:
// at 0 an element inverts, and the condition of the element's matrices grows with the inverse.
static const double LEAST_JACOBIAN = 0.1;

// halvings of the edges along curves before giving up
enum { MOST_TRIES = 7 };

// OpenCASCADE integrates areas to better than this, and places intersections to 1e-7
static const double AREA_TOLERANCE = 1e-6;

// --- what gmsh answered

static void turn_triangles(plane_pieces *p)
{
    for (int k = 0; k < p->ntriangle; k++) {
        int *c = p->corner + 3 * (size_t)k;
        const double *x = p->xy + 2 * (size_t)c[0], *y = p->xy + 2 * (size_t)c[1],
                     *z = p->xy + 2 * (size_t)c[2];
        if ((y[0] - x[0]) * (z[1] - x[1]) < (z[0] - x[0]) * (y[1] - x[1])) {
            const int swap = c[1];
            c[1] = c[2];
            c[2] = swap;
        }
    }
}

// every face is filled to its exact area
static status check_areas(const section_outline *o, const plane_pieces *p, const curved_sides *s)
{
    status st = OK;
    double *area = NULL;
    TRY(TAKE(area, (size_t)p->nface));
    for (int k = 0; k < p->ntriangle; k++) {
        area[p->face[k]] += curved_triangle_area(p, s, k);
    }
    for (int f = 0; f < p->nface; f++) {
        // of the face, and of a boundary that is off by the tolerance all around
        const double allowed = AREA_TOLERANCE * (p->area[f] + sqrt(p->area[f]));
        if (!(fabs(area[f] - p->area[f]) <= allowed)) {
            TRY(outline_fail(&o->items[p->owner[f]], p->owner[f],
                             "the free mesher filled an area of %.9g instead of %.9g (of the "
                             "section's size squared); the shapes meet at too small an angle or "
                             "gap there",
                             area[f], p->area[f]));
        }
    }

done:
    free(area);
    return st;
}

// the owner by gmsh's books is the shape on top in the middle of an element of the face
static status check_owners(const section_outline *o, const plane_pieces *p, const curved_sides *s)
{
    status st = OK;
    const double middle[3] = {1.0 / 3, 1.0 / 3, 1.0 / 3};
    bool *agrees = NULL;
    TRY(TAKE(agrees, (size_t)p->nface));
    for (int k = 0; k < p->ntriangle; k++) {
        const int f = p->face[k];
        if (!agrees[f]) {
            double x[2];
            curved_triangle_point(p, s, k, middle, x);
            agrees[f] = section_top_shape(o, x[0] * o->size, x[1] * o->size) == p->owner[f];
        }
    }
    for (int f = 0; f < p->nface; f++) {
        if (!agrees[f]) {
            TRY(status_fail(ERR_NUMERIC, "the free mesher gave an area to shape %d that is not its",
                            p->owner[f] + 1));
        }
    }

done:
    free(agrees);
    return st;
}

// --- curved elements that all but invert: shorter edges are asked for there

// half the length at the bent sides of bad elements; *count of such elements, *worst the last of
// them
static status refine_at_bad(const mesh *m, const plane_pieces *p, const curved_sides *s,
                            plane_request *r, int *count, int *worst)
{
    status st = OK;
    double least = INFINITY;
    *count = 0;
    TRY(mesh_min_jacobian(m, &least));
    for (int k = 0; k < m->block[0].nelem && !(least >= LEAST_JACOBIAN); k++) {
        // a view of one element
        mesh one = *m;
        one.block[0].nelem = 1;
        one.block[0].conn += (size_t)k * (size_t)one.block[0].per_elem;
        double ratio = 0;
        TRY(mesh_min_jacobian(&one, &ratio));
        if (ratio >= LEAST_JACOBIAN) {
            continue;
        }
        *worst = k;
        ++*count;
        for (int i = 0; i < 3; i++) {
            const int edge = s->edges.of[3 * k + i], *end = s->edges.end[edge];
            if (s->bend[edge].curve >= 0 && s->bend[edge].round) {
                const double *x = p->xy + 2 * (size_t)end[0], *y = p->xy + 2 * (size_t)end[1];
                TRY(plane_add_source(r, (x[0] + y[0]) / 2, (x[1] + y[1]) / 2,
                                     hypot(y[0] - x[0], y[1] - x[1]) / 2));
            }
        }
    }

done:
    return st;
}

typedef struct attempt {
    plane_pieces pieces;
    curved_sides sides;
    mesh m, judged; // judged: at order 2 for a mesh of order 1, whose elements do not show how
                    // their curves lie
} attempt;

static void attempt_free(attempt *a)
{
    plane_pieces_free(&a->pieces);
    curved_sides_free(&a->sides);
    mesh_free(&a->m);
    mesh_free(&a->judged);
}

static status try_once(const section_outline *o, plane_request *request, int order, attempt *a)
{
    status st = OK;
    TRY(free_child_run(request, &a->pieces));
    if (a->pieces.ntriangle > SECTION_MOST_ELEMENTS) {
        TRY(status_fail(ERR_INPUT, "mesh: its size asks for more than %d elements",
                        SECTION_MOST_ELEMENTS));
    }
    turn_triangles(&a->pieces);
    TRY(curved_sides_make(&a->pieces, o, &a->sides));
    TRY(check_areas(o, &a->pieces, &a->sides));
    TRY(curved_mesh_make(&a->pieces, o, &a->sides, order, &a->m));
    if (order == 1) {
        TRY(curved_mesh_make(&a->pieces, o, &a->sides, 2, &a->judged));
    }

done:
    return st;
}

static status take_owners(const plane_pieces *p, int **owner)
{
    status st = OK;
    TRY(TAKE(*owner, (size_t)p->ntriangle));
    for (int k = 0; k < p->ntriangle; k++) {
        (*owner)[k] = p->owner[p->face[k]];
    }

done:
    return st;
}

static status fail_at(const section_outline *o, const attempt *a, int worst)
{
    const mesh_block *b = &a->m.block[0];
    const double *x = a->m.xyz + 3 * (size_t)b->conn[(size_t)worst * (size_t)b->per_elem];
    const int owner = a->pieces.owner[a->pieces.face[worst]];
    return outline_fail(&o->items[owner], owner,
                        "near (%g, %g) mm its curved edge meets another edge at too small an angle "
                        "or gap to be meshed",
                        x[0] * 1e3, x[1] * 1e3);
}

status free_mesh_make(const section_outline *o, const mesh_options *options, mesh *out, int **owner)
{
    status st = OK;
    attempt a = {0};
    plane_request request = {.divide = plane_divide,
                             .size_at = plane_size_at,
                             .length = sizing_length(options, o->size) / o->size,
                             .angle = sizing_angle(options)};
    int bad = 1, worst = 0;

    TRY(section_check_thickness(o));
    TRY(plane_shapes_make(o, &request));
    for (int k = 0; k < MOST_TRIES && bad > 0; k++) {
        attempt_free(&a);
        a = (attempt){0};
        TRY(try_once(o, &request, options->order, &a));
        TRY(refine_at_bad(options->order == 1 ? &a.judged : &a.m, &a.pieces, &a.sides, &request,
                          &bad, &worst));
    }
    if (bad > 0) {
        TRY(fail_at(o, &a, worst));
    }
    TRY(check_owners(o, &a.pieces, &a.sides));
    TRY(take_owners(&a.pieces, owner));
    *out = a.m;
    a.m = (mesh){0};

done:
    attempt_free(&a);
    plane_request_free(&request);
    return st;
}
