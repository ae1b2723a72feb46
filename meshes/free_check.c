// meshes/free_check.c
#include "meshes/free_check.h"

#include "base/memory.h"
#include "meshes/outline.h"

#include <math.h>

// OpenCASCADE integrates areas to better than this, and places corners to 1e-7
static const double AREA_TOLERANCE = 1e-6;

status pieces_check_indices(const plane_pieces *p)
{
    bool good = p->ntriangle > 0;
    for (int i = 0; i < 3 * p->ntriangle; i++) {
        good = good && p->corner[i] >= 0 && p->corner[i] < p->nnode;
    }
    for (int i = 0; i < 2 * p->nsegment; i++) {
        good = good && p->segment[i] >= 0 && p->segment[i] < p->nnode;
    }
    return good ? OK : status_fail(ERR_NUMERIC, "the free mesher's elements make no sense");
}

static double straight_area(const plane_pieces *p, int triangle)
{
    const int *c = p->corner + 3 * (size_t)triangle;
    const double *x = p->xy + 2 * (size_t)c[0], *y = p->xy + 2 * (size_t)c[1],
                 *z = p->xy + 2 * (size_t)c[2];
    return ((y[0] - x[0]) * (z[1] - x[1]) - (z[0] - x[0]) * (y[1] - x[1])) / 2;
}

status pieces_turn_faces(plane_pieces *p)
{
    status st = OK;
    double *area = NULL;
    TRY(TAKE(area, (size_t)p->nface));
    for (int k = 0; k < p->ntriangle; k++) {
        area[p->face[k]] += straight_area(p, k);
    }
    for (int k = 0; k < p->ntriangle; k++) {
        int *c = p->corner + 3 * (size_t)k;
        const int second = c[1];
        if (area[p->face[k]] < 0) {
            c[1] = c[2];
            c[2] = second;
        }
    }

done:
    free(area);
    return st;
}

status pieces_find_unfilled(const plane_pieces *p, const curved_sides *s, bool *unfilled,
                            int *count)
{
    status st = OK;
    double *area = NULL;
    *count = 0;
    TRY(TAKE(area, (size_t)p->nface));
    for (int k = 0; k < p->ntriangle; k++) {
        area[p->face[k]] += curved_triangle_area(p, s, k);
    }
    for (int f = 0; f < p->nface; f++) {
        // of the face, and of a boundary that is off by the tolerance all around
        const double allowed = AREA_TOLERANCE * (p->area[f] + sqrt(p->area[f]));
        unfilled[f] = !(fabs(area[f] - p->area[f]) <= allowed);
        *count += unfilled[f];
    }

done:
    free(area);
    return st;
}

// one element of the face that lies where it should is enough: the face is all of it or nothing
status pieces_check_owners(const plane_pieces *p, const curved_sides *s, const section_outline *o)
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
            TRY(status_fail(ERR_NUMERIC,
                            "the free mesher gave an area to %s that is not its; do edges of "
                            "shapes all but coincide?",
                            o->items[p->owner[f]].called));
        }
    }

done:
    free(agrees);
    return st;
}
