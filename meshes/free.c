// meshes/free.c
#include "meshes/free.h"

#include "base/memory.h"
#include "meshes/curved.h"
#include "meshes/edge_pieces.h"
#include "meshes/free_check.h"
#include "meshes/free_child.h"
#include "meshes/outline.h"
#include "meshes/plane_shapes.h"
#include "meshes/plane_sizing.h"
#include "meshes/sizing.h"

#include <math.h>
#include <stdlib.h>
#include <time.h>

// An element's det J may fall to this part of its mean. Below, shorter edges are asked for: at 0 an
// element inverts, and the condition of its matrices grows with the inverse.
static const double LEAST_JACOBIAN = 0.1;

enum {
    MOST_TRIES = 8, // each halves the edges where elements are bad
    PATIENCE = 15,  // [s] no new try after that
    MOST_SOURCES = 2000,
    MOST_HALVINGS = 3, // of all arcs, where a face has no triangle at all
};

typedef struct attempt {
    plane_pieces pieces;
    curved_sides sides;
    mesh m, judged; // judged: of order 2 where m is of order 1 and does not show how its curves lie
    int nbad;       // elements or faces
    bool lost;      // a face has no triangle at all
    int bad_face;   // one of them
    double at[2];   // a place there
} attempt;

static void attempt_free(attempt *a)
{
    plane_pieces_free(&a->pieces);
    curved_sides_free(&a->sides);
    mesh_free(&a->m);
    mesh_free(&a->judged);
    *a = (attempt){0};
}

// half the length at the bent sides of a bad triangle
static status refine_triangle(attempt *a, plane_request *r, int triangle)
{
    status st = OK;
    const curved_sides *s = &a->sides;
    for (int i = 0; i < 3; i++) {
        const int edge = s->edges.of[3 * triangle + i], *end = s->edges.end[edge];
        const double *x = a->pieces.xy + 2 * (size_t)end[0], *y = a->pieces.xy + 2 * (size_t)end[1];
        a->bad_face = a->pieces.face[triangle];
        a->at[0] = x[0];
        a->at[1] = x[1];
        if (s->bend[edge].on >= 0 && r->nsource < MOST_SOURCES) {
            TRY(plane_add_source(r, (x[0] + y[0]) / 2, (x[1] + y[1]) / 2,
                                 hypot(y[0] - x[0], y[1] - x[1]) / 2));
        }
    }

done:
    return st;
}

// Faces that are not filled: the chords of their curves cross one another or another curve.
static status refine_unfilled(attempt *a, plane_request *r)
{
    status st = OK;
    bool *unfilled = NULL;
    const int before = r->nsource;
    TRY(TAKE(unfilled, (size_t)a->pieces.nface));
    TRY(pieces_find_unfilled(&a->pieces, &a->sides, unfilled, &a->nbad));
    for (int f = 0; f < a->pieces.nface; f++) {
        a->bad_face = unfilled[f] ? f : a->bad_face;
    }
    for (int k = 0; k < a->pieces.ntriangle; k++) {
        if (unfilled[a->pieces.face[k]]) {
            TRY(refine_triangle(a, r, k));
        }
    }
    // a face without any triangle does not say where: all arcs become finer
    if (a->nbad > 0 && r->nsource == before) {
        r->angle /= 2;
        a->lost = true;
    }

done:
    free(unfilled);
    return st;
}

// Curved elements that invert or all but invert.
static status refine_inverted(attempt *a, plane_request *r)
{
    status st = OK;
    const mesh *m = a->m.order == 1 ? &a->judged : &a->m;
    double least = INFINITY;
    TRY(mesh_min_jacobian(m, &least));
    for (int k = 0; k < m->block[0].nelem && !(least >= LEAST_JACOBIAN); k++) {
        // a view of one element
        mesh one = *m;
        one.block[0].nelem = 1;
        one.block[0].conn += (size_t)k * (size_t)one.block[0].per_elem;
        double ratio = 0;
        TRY(mesh_min_jacobian(&one, &ratio));
        if (!(ratio >= LEAST_JACOBIAN)) {
            a->nbad++;
            TRY(refine_triangle(a, r, k));
        }
    }

done:
    return st;
}

// One mesh, and what to ask for in the next one where it is bad.
static status try_once(const section_outline *o, plane_request *r, int order, attempt *a)
{
    status st = OK;
    TRY(free_child_run(r, &a->pieces));
    if (a->pieces.ntriangle > SECTION_MOST_ELEMENTS) {
        TRY(status_fail(ERR_INPUT, "mesh: its size asks for more than %d elements",
                        SECTION_MOST_ELEMENTS));
    }
    TRY(pieces_check_indices(&a->pieces));
    TRY(pieces_turn_faces(&a->pieces));
    TRY(curved_sides_make(&a->pieces, o, &a->sides));
    TRY(refine_unfilled(a, r));
    if (a->nbad > 0) {
        goto done;
    }
    TRY(curved_mesh_make(&a->pieces, o, &a->sides, order, &a->m));
    if (order == 1) {
        TRY(curved_mesh_make(&a->pieces, o, &a->sides, 2, &a->judged));
    }
    TRY(refine_inverted(a, r));

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

static status fail_at(const section_outline *o, const attempt *a)
{
    const outline *owner = &o->items[a->pieces.owner[a->bad_face]];
    if (a->lost) {
        return outline_fail(owner,
                            "an edge of it meets another edge at too small an angle or gap to be "
                            "meshed");
    }
    return outline_fail(owner,
                        "near (%g, %g) mm its edge meets another edge at too small an angle or gap "
                        "to be meshed",
                        a->at[0] * o->size * 1e3, a->at[1] * o->size * 1e3);
}

static double wall_seconds(void)
{
    struct timespec t = {0};
    (void)clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

status free_mesh_make(const section_outline *o, const mesh_options *options, mesh *out, int **owner)
{
    status st = OK;
    attempt a = {.nbad = 1};
    const bool layered = options->edge_layers > 0;
    double (*shrink)(const mesh_options *, corner) = layered ? sizing_edge_shrink : sizing_shrink;
    plane_request request = {
        .check = plane_check,
        .drawn = o,
        .parts = plane_parts,
        .size_at = plane_size_at,
        .length = (layered ? sizing_edge_length : sizing_length)(options, o->size) / o->size,
        .angle = (layered ? sizing_edge_angle : sizing_angle)(options),
        .towards_corners = options->size > 0 ? NULL : o,
        .shrink = {1, shrink(options, CORNER_WEAK), shrink(options, CORNER_STRONG)}};

    TRY(section_check_thickness(o));
    TRY(plane_shapes_make(o, &request));
    const double begin = wall_seconds();
    for (int k = 0, lost = 0;
         k < MOST_TRIES && lost <= MOST_HALVINGS && a.nbad > 0 && wall_seconds() - begin < PATIENCE;
         k++) {
        attempt_free(&a);
        TRY(try_once(o, &request, options->order, &a));
        lost += a.lost;
    }
    if (a.nbad > 0) {
        TRY(fail_at(o, &a));
    }
    TRY(pieces_check_owners(&a.pieces, &a.sides, o));
    if (layered) {
        TRY(edge_mesh_make(&a.pieces, o, &a.sides, options, out, owner));
    } else {
        TRY(take_owners(&a.pieces, owner));
        *out = a.m;
        a.m = (mesh){0};
    }

done:
    attempt_free(&a);
    plane_request_free(&request);
    return st;
}
