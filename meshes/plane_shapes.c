// meshes/plane_shapes.c
#include "meshes/plane_shapes.h"

#include "base/memory.h"
#include "meshes/loops.h"
#include "meshes/outline.h"
#include "meshes/polygon.h"

#include <math.h>
#include <string.h>

// a sector's arcs stay well below a half turn
static const double LARGEST_ARC = 2;

enum { SECTOR_SIDES = 12 }; // at most: four arcs on either circle, two lines, and room to spare

void plane_request_free(plane_request *r)
{
    free(r->cuts);
    free(r->loop_start);
    free(r->side_start);
    free(r->side);
    free(r->source);
    *r = (plane_request){0};
}

typedef struct writer {
    plane_request *r;
    const section_outline *o;
    int nloop, nside;
} writer;

static void end_loop(writer *w)
{
    w->r->side_start[++w->nloop] = w->nside;
}

static void add_line(writer *w, double x, double y)
{
    const double unit = w->o->size;
    w->r->side[w->nside++] = (plane_side){.kind = SIDE_LINE, .from = {x / unit, y / unit}};
}

static void add_round(writer *w, side_kind kind, const double *centre, double radius, double angle)
{
    const double unit = w->o->size;
    w->r->side[w->nside++] = (plane_side){.kind = kind,
                                          .from = {(centre[0] + radius * cos(angle)) / unit,
                                                   (centre[1] + radius * sin(angle)) / unit},
                                          .centre = {centre[0] / unit, centre[1] / unit}};
}

static void add_arcs(writer *w, const double *centre, double radius, double from, double to)
{
    const int n = (int)ceil(fabs(to - from) / LARGEST_ARC);
    for (int i = 0; i < n; i++) {
        add_round(w, SIDE_ARC, centre, radius, from + (to - from) * i / n);
    }
}

// A circle begins where a sector about the same centre has an edge, so that its first point does
// not come to lie just beside a corner of that.
static double first_angle(const section_outline *o, const outline *ring)
{
    for (int k = o->count - 1; k >= 0; k--) {
        const outline *p = &o->items[k];
        const double off = hypot(p->centre[0] - ring->centre[0], p->centre[1] - ring->centre[1]);
        if (p->kind == KIND_SECTOR && off <= OUTLINE_MERGE * o->size) {
            return p->mid_angle - p->width / 2;
        }
    }
    return o->turn;
}

static void add_ring(writer *w, const outline *o)
{
    const double start = first_angle(w->o, o);
    add_round(w, SIDE_CIRCLE, o->centre, o->outer, start);
    end_loop(w);
    if (o->inner > 0) {
        add_round(w, SIDE_CIRCLE, o->centre, o->inner, start);
        end_loop(w);
    }
}

static void add_sector(writer *w, const outline *o)
{
    const double a = o->mid_angle - o->width / 2, b = o->mid_angle + o->width / 2;
    add_arcs(w, o->centre, o->outer, a, b);
    add_line(w, o->centre[0] + o->outer * cos(b), o->centre[1] + o->outer * sin(b));
    if (o->inner > 0) {
        add_arcs(w, o->centre, o->inner, b, a);
    }
    add_line(w, o->centre[0] + o->inner * cos(a), o->centre[1] + o->inner * sin(a));
    end_loop(w);
}

static void add_rectangle(writer *w, const outline *o)
{
    double corner[4][2];
    rectangle_corners(o, corner);
    for (int i = 0; i < 4; i++) {
        add_line(w, corner[i][0], corner[i][1]);
    }
    end_loop(w);
}

// all loops counter-clockwise: OpenCASCADE's area of a face counts holes that run the other way as
// filled
static void add_polygon(writer *w, const outline *o)
{
    for (int k = 0; k < o->nloop; k++) {
        const loop a = outline_loop(o, k);
        for (int i = 0; i < a.n; i++) {
            const double *x = a.p + 2 * (k == 0 ? i : a.n - 1 - i);
            add_line(w, x[0], x[1]);
        }
        end_loop(w);
    }
}

static bool is_circle(const carrier *c)
{
    const double *u = c->p[1], *v = c->p[2], a = hypot(u[0], u[1]), b = hypot(v[0], v[1]);
    return fabs(a - b) <= OUTLINE_MERGE * a &&
           fabs(u[0] * v[0] + u[1] * v[1]) <= OUTLINE_MERGE * a * b;
}

static void add_piece(writer *w, const carrier *c)
{
    const carrier unit = carrier_scaled(c, 1 / w->o->size);
    double h[CARRIER_HULL][2];
    plane_side s = {.kind = SIDE_LINE};
    (void)carrier_hull(&unit, unit.from, unit.to, h);
    memcpy(s.from, h[0], sizeof s.from);
    if (c->kind == CARRIER_CUBIC) {
        s.kind = SIDE_BEZIER;
        memcpy(s.control, h[1], sizeof s.control);
    } else if (c->kind == CARRIER_ELLIPSE && is_circle(c)) {
        s.kind = SIDE_ARC;
        memcpy(s.centre, unit.p[0], sizeof s.centre);
    } else if (c->kind == CARRIER_ELLIPSE) {
        s.kind = SIDE_ELLIPSE;
        memcpy(s.control[0], h[1], sizeof s.control[0]);
        s.weight = cos((c->to - c->from) / 2);
    }
    w->r->side[w->nside++] = s;
}

static void add_loops(writer *w, const outline *o)
{
    for (int k = 0; k < o->nloop; k++) {
        const curve_loop a = outline_curves(o, k);
        for (int i = 0; i < a.n; i++) {
            add_piece(w, &a.piece[i]);
        }
        end_loop(w);
    }
}

static void add_shape(writer *w, const outline *o)
{
    switch (o->kind) {
    case KIND_LOOPS:
        add_loops(w, o);
        break;
    case KIND_SECTOR:
        add_sector(w, o);
        break;
    case KIND_RECTANGLE:
        add_rectangle(w, o);
        break;
    case KIND_POLYGON:
        add_polygon(w, o);
        break;
    default:
        add_ring(w, o);
        break;
    }
}

status plane_shapes_make(const section_outline *o, plane_request *out)
{
    status st = OK;
    writer w = {.r = out, .o = o};
    size_t nloop = 0, nside = 0;

    for (int k = 0; k < o->count; k++) {
        const outline *p = &o->items[k];
        nloop += p->nloop > 0 ? (size_t)p->nloop : 2;
        nside += p->nloop > 0 ? (size_t)p->loop_start[p->nloop] : SECTOR_SIDES;
    }
    out->nshape = o->count;
    TRY(TAKE(out->cuts, (size_t)o->count));
    TRY(TAKE(out->loop_start, (size_t)o->count + 1));
    TRY(TAKE(out->side_start, nloop + 1));
    TRY(TAKE(out->side, nside));
    for (int k = 0; k < o->count; k++) {
        out->cuts[k] = o->items[k].material < 0;
        add_shape(&w, &o->items[k]);
        out->loop_start[k + 1] = w.nloop;
    }

done:
    return st;
}
