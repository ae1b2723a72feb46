// meshes/plane_sizing.c
#include "meshes/plane_sizing.h"

#include "base/memory.h"
#include "meshes/corner.h"
#include "meshes/outline.h"
#include "meshes/sizing.h"

#include <math.h>

#define PI 3.14159265358979323846

// lengths grow by this part of the distance from a place that asks for short ones
static const double GROWTH = 0.5;

status section_check_thickness(const section_outline *o)
{
    double part = 0;
    const int thinnest = section_thinnest_shape(o, &part);
    if (thinnest >= 0 && part < OUTLINE_SLIVER) {
        return outline_fail(&o->items[thinnest],
                            "it is thinner than %g of the section's size from its origin",
                            OUTLINE_SLIVER);
    }
    return OK;
}

// the boundary of a long thin face is twice its area over its width
static status check_slivers(const plane_request *r, const plane_pieces *p)
{
    for (int f = 0; f < p->nface; f++) {
        if (!(2 * p->area[f] >= OUTLINE_SLIVER * p->around[f])) {
            return outline_fail(&r->drawn->items[p->owner[f]],
                                "the overlaps leave a sliver of it, thinner than %g of the "
                                "section's size",
                                OUTLINE_SLIVER);
        }
    }
    return OK;
}

static double source_limit(const plane_request *r, const double *x)
{
    double limit = INFINITY;
    for (int i = 0; i < r->nsource; i++) {
        const double *s = r->source + 3 * (size_t)i;
        limit = fmin(limit, s[2] + GROWTH * hypot(x[0] - s[0], x[1] - s[1]));
    }
    return limit;
}

status plane_add_source(plane_request *r, double x, double y, double length)
{
    double *more = realloc(r->source, 3 * ((size_t)r->nsource + 1) * sizeof *more);
    if (!more) {
        return status_fail(ERR_RESOURCE, "out of memory");
    }
    r->source = more;
    double *s = more + 3 * (size_t)r->nsource++;
    s[0] = x;
    s[1] = y;
    s[2] = length;
    return OK;
}

static double turn_at(const double *a, const double *b, const double *c)
{
    const double ux = b[0] - a[0], uy = b[1] - a[1], vx = c[0] - b[0], vy = c[1] - b[1];
    return fabs(atan2(ux * vy - uy * vx, ux * vx + uy * vy));
}

// by how much a curve's tangent turns in all: between its probes, and as much again at the ends as
// a circle would
static double turn_of(const double *probe)
{
    double turn = 0;
    for (int i = 1; i < CURVE_PROBES - 1; i++) {
        turn += turn_at(probe + 2 * (i - 1), probe + 2 * i, probe + 2 * (i + 1));
    }
    return turn * (CURVE_PROBES - 1) / (CURVE_PROBES - 2);
}

// equilateral triangles of the target size, before they are made
static status check_count(const plane_request *r, const plane_pieces *p)
{
    double area = 0;
    for (int f = 0; f < p->nface; f++) {
        area += p->area[f];
    }
    if (!(area / (sqrt(3) / 4 * r->length * r->length) < SECTION_MOST_ELEMENTS)) {
        return status_fail(ERR_INPUT, "mesh: its size asks for more than %d elements",
                           SECTION_MOST_ELEMENTS);
    }
    return OK;
}

// how many equal edges a curve takes by the length and the arc
static double natural_parts(const plane_request *r, int curve)
{
    const plane_pieces *p = r->known;
    const double turn = turn_of(p->probe + 2 * CURVE_PROBES * (size_t)curve);
    const double closed = turn > PI ? 3 : 1;
    return fmax(fmax(closed, sizing_parts(turn, r->angle)),
                sizing_parts(p->length[curve], r->length));
}

double plane_size_at(int dim, int tag, double x, double y, double z, void *request)
{
    (void)z;
    const plane_request *r = request;
    const plane_pieces *p = r->known;
    const double at[2] = {x, y};
    double size = r->length;
    for (int i = 0; dim == 1 && i < p->ncurve; i++) {
        if (p->tag[i] == tag) {
            size = p->length[i] / natural_parts(r, i);
        }
    }
    return fmin(size, source_limit(r, at));
}

int plane_parts(const plane_request *r, int curve)
{
    const plane_pieces *p = r->known;
    const double n = natural_parts(r, curve);
    for (int k = 0; k < CURVE_PROBES; k++) {
        const double *x = p->probe + 2 * (CURVE_PROBES * (size_t)curve + (size_t)k);
        if (source_limit(r, x) < p->length[curve] / n) {
            return 0;
        }
    }
    return (int)n;
}

// Edge length of the outermost layer at a corner over that of its surroundings: the nearest other
// corner, or the target.
static const double AT_WEAK = 0.25, AT_STRONG = 0.5;

// a drawing with more ends of curves than this has no room for refinement at each
enum { MOST_CORNERS = 300 };

static const double *curve_end(const plane_pieces *p, int i)
{
    const size_t last = CURVE_PROBES - 1;
    return p->probe + 2 * (CURVE_PROBES * (size_t)(i / 2) + (i % 2 ? last : 0));
}

static status add_corners(plane_request *r)
{
    status st = OK;
    const plane_pieces *p = r->known;
    const section_outline *o = r->towards_corners;
    const int n = 2 * p->ncurve;
    for (int i = 0; i < n && n <= MOST_CORNERS; i++) {
        const double *x = curve_end(p, i);
        double around = r->length;
        bool first = true;
        for (int k = 0; k < n; k++) {
            const double *y = curve_end(p, k), d = hypot(x[0] - y[0], x[1] - y[1]);
            const bool same = d < OUTLINE_SLIVER / 2;
            first = first && !(same && k < i);
            around = same ? around : fmin(around, d);
        }
        const double near = fmin(around / 100, OUTLINE_SLIVER * 10) * o->size;
        const corner c = first ? corner_at(o, x[0] * o->size, x[1] * o->size, near) : CORNER_NONE;
        if (c != CORNER_NONE) {
            const double part = (c == CORNER_WEAK ? AT_WEAK : AT_STRONG) * r->shrink[c];
            TRY(plane_add_source(r, x[0], x[1], part * around));
        }
    }

done:
    return st;
}

// sources on one curve that ask for less than this part of the other's length are one
static const double WORTH_A_SOURCE = 0.8;

// Where a curve bends more than on average, edges turn by no more than the angle: an ellipse has
// short ones at its ends only.
static status add_bends(plane_request *r, int curve)
{
    status st = OK;
    const plane_pieces *p = r->known;
    const double *probe = p->probe + 2 * CURVE_PROBES * (size_t)curve;
    const double even = p->length[curve] / natural_parts(r, curve);
    for (int i = 1; i < CURVE_PROBES - 1; i++) {
        const double *x = probe + 2 * i, *y = x + 2;
        const double step = hypot(y[0] - x[0], y[1] - x[1]);
        const double wanted = step * r->angle / turn_at(x - 2, x, y);
        if (wanted < WORTH_A_SOURCE * fmin(even, source_limit(r, x))) {
            TRY(plane_add_source(r, x[0], x[1], wanted));
        }
    }

done:
    return st;
}

status plane_check(plane_request *r, const plane_pieces *p)
{
    status st = OK;
    r->known = p;
    TRY(check_slivers(r, p));
    TRY(check_count(r, p));
    if (r->towards_corners) {
        TRY(add_corners(r));
    }
    for (int i = 0; i < p->ncurve; i++) {
        const double *x = p->probe + 2 * CURVE_PROBES * (size_t)i;
        if (p->length[i] < OUTLINE_SLIVER) {
            TRY(status_fail(ERR_INPUT,
                            "the overlaps of the shapes leave an edge at (%g, %g) of the section's "
                            "size that is shorter than %g of it",
                            x[0], x[1], OUTLINE_SLIVER));
        }
        if (!(natural_parts(r, i) < SECTION_MOST_ELEMENTS)) {
            TRY(status_fail(ERR_INPUT, "mesh: its size asks for more than %d elements",
                            SECTION_MOST_ELEMENTS));
        }
        TRY(add_bends(r, i));
    }

done:
    return st;
}
