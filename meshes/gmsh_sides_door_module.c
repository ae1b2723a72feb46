// meshes/gmsh_sides_door_module.c
// Lines, arcs, circles, ellipses and cubics as OpenCASCADE's curves.
#include "base/memory.h"
#include "meshes/gmsh_sides.h"

#include <gmshc.h>
#include <math.h>

#define PI 3.14159265358979323846

enum { POINT };

// with control points between its ends: a rational curve of degree 2, or a cubic
static status add_controlled(const plane_side *s, int from, int to, int *curve)
{
    status st = OK;
    const bool rational = s->kind == SIDE_ELLIPSE;
    const int n = rational ? 3 : 4;
    int points[4] = {from, to, to, to}, multiplicity[2] = {n, n};
    double weights[4] = {1, rational ? s->weight : 1, 1, 1}, knots[2] = {0, 1};
    for (int i = 1; i < n - 1; i++) {
        const double *x = s->control[i - 1];
        GMSH_TRY(points[i] = gmshModelOccAddPoint(x[0], x[1], 0, 0, -1, &ierr));
    }
    const size_t count = (size_t)n;
    GMSH_TRY(*curve =
                 gmshModelOccAddBSpline(points, count, -1, n - 1, weights, rational ? count : 0,
                                        knots, 2, multiplicity, 2, &ierr));
    for (int i = 1; i < n - 1; i++) {
        int dim_tag[2] = {POINT, points[i]};
        GMSH_TRY(gmshModelOccRemove(dim_tag, 2, 0, &ierr));
    }

done:
    return st;
}

// from, to: points; not used by a full circle
static status add_side(const plane_side *s, int from, int to, int *curve)
{
    status st = OK;
    const double *c = s->centre, dx = s->from[0] - c[0], dy = s->from[1] - c[1], a = atan2(dy, dx);
    int middle[2] = {POINT, 0};
    if (s->kind == SIDE_LINE) {
        GMSH_TRY(*curve = gmshModelOccAddLine(from, to, -1, &ierr));
    } else if (s->kind == SIDE_CIRCLE) {
        GMSH_TRY(*curve =
                     gmshModelOccAddCircle(c[0], c[1], 0, hypot(dx, dy), -1, a, a + 2 * PI, &ierr));
    } else if (s->kind == SIDE_ELLIPSE || s->kind == SIDE_BEZIER) {
        TRY(add_controlled(s, from, to, curve));
    } else {
        GMSH_TRY(middle[1] = gmshModelOccAddPoint(c[0], c[1], 0, 0, -1, &ierr));
        GMSH_TRY(*curve = gmshModelOccAddCircleArc(from, middle[1], to, -1, &ierr));
        GMSH_TRY(gmshModelOccRemove(middle, 2, 0, &ierr));
    }

done:
    return st;
}

static status add_loop(int n, const plane_side *side, int *tag)
{
    status st = OK;
    int *points = NULL, *curves = NULL;
    TRY(TAKE(points, (size_t)n));
    TRY(TAKE(curves, (size_t)n));
    for (int i = 0; i < n && side[i].kind != SIDE_CIRCLE; i++) {
        const double *x = side[i].from;
        GMSH_TRY(points[i] = gmshModelOccAddPoint(x[0], x[1], 0, 0, -1, &ierr));
    }
    for (int i = 0; i < n; i++) {
        TRY(add_side(&side[i], points[i], points[(i + 1) % n], &curves[i]));
    }
    GMSH_TRY(*tag = gmshModelOccAddCurveLoop(curves, (size_t)n, -1, &ierr));

done:
    free(points);
    free(curves);
    return st;
}

status gmsh_add_shape(const plane_request *r, int shape, int *face)
{
    status st = OK;
    const int first = r->loop_start[shape], n = r->loop_start[shape + 1] - first;
    int *loops = NULL;
    TRY(TAKE(loops, (size_t)n));
    for (int k = 0; k < n; k++) {
        const int *start = r->side_start + first + k;
        TRY(add_loop(start[1] - start[0], r->side + start[0], &loops[k]));
    }
    GMSH_TRY(*face = gmshModelOccAddPlaneSurface(loops, (size_t)n, -1, &ierr));

done:
    free(loops);
    return st;
}
