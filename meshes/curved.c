// meshes/curved.c
#include "meshes/curved.h"

#include "base/memory.h"
#include "meshes/outline.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

// a curve leaves its chord, and a circle is found again, to well above OpenCASCADE's own tolerance
// of 1e-7
static const double OWN_CIRCLE = 1e-6;
// below this part of the chord a curve is straight to rounding
static const double STRAIGHT = 1e-9;

void curved_sides_free(curved_sides *s)
{
    edge_list_free(&s->edges);
    free(s->bend);
    *s = (curved_sides){0};
}

static bool bends(const double *probe, double length)
{
    const double *mid = probe + CURVE_PROBES - 1, *end = probe + 2 * (CURVE_PROBES - 1);
    const double dx = end[0] - probe[0], dy = end[1] - probe[1], chord = hypot(dx, dy);
    if (chord < length / 2) {
        return true;
    }
    const double off = dx * (mid[1] - probe[1]) - dy * (mid[0] - probe[0]);
    return fabs(off) > STRAIGHT * chord * chord;
}

// the circle among the outlines on which the points lie best
static status find_circle(const double *probe, const section_outline *o, double *centre)
{
    double best = OWN_CIRCLE;
    bool found = false;
    for (int k = 0; k < o->count; k++) {
        const outline *p = &o->items[k];
        if (p->kind == KIND_RECTANGLE || p->kind == KIND_POLYGON) {
            continue;
        }
        const double c[2] = {p->centre[0] / o->size, p->centre[1] / o->size};
        for (int which = 0; which < 2; which++) {
            const double r = (which ? p->inner : p->outer) / o->size;
            double off = 0;
            for (int i = 0; i < CURVE_PROBES; i++) {
                const double d = hypot(probe[2 * i] - c[0], probe[2 * i + 1] - c[1]);
                off = fmax(off, fabs(d - r));
            }
            if (r > 0 && off < best) {
                best = off;
                found = true;
                memcpy(centre, c, sizeof c);
            }
        }
    }
    return found ? OK : status_fail(ERR_NUMERIC, "the free mesher bent a curve that no shape drew");
}

static int find_edge(const edge_list *e, int a, int b)
{
    const int low = a < b ? a : b, high = a < b ? b : a;
    int from = 0, to = e->nedge - 1;
    while (from < to) {
        const int mid = (from + to) / 2;
        const int *end = e->end[mid];
        if (end[0] < low || (end[0] == low && end[1] < high)) {
            from = mid + 1;
        } else {
            to = mid;
        }
    }
    return e->end[from][0] == low && e->end[from][1] == high ? from : -1;
}

status curved_sides_make(const plane_pieces *pieces, const section_outline *o, curved_sides *out)
{
    status st = OK;
    curved_sides s = {0};
    bend *of_curve = NULL;

    TRY(edge_list_make(pieces->ntriangle, 3, pieces->corner, &s.edges));
    TRY(TAKE(s.bend, (size_t)s.edges.nedge));
    TRY(TAKE(of_curve, (size_t)pieces->ncurve));
    for (int i = 0; i < s.edges.nedge; i++) {
        s.bend[i].curve = -1;
    }
    for (int i = 0; i < pieces->ncurve; i++) {
        const double *probe = pieces->probe + 2 * CURVE_PROBES * (size_t)i;
        of_curve[i].curve = i;
        of_curve[i].round = bends(probe, pieces->length[i]);
        if (of_curve[i].round) {
            TRY(find_circle(probe, o, of_curve[i].centre));
        }
    }
    for (int i = 0; i < pieces->nsegment; i++) {
        const int edge = find_edge(&s.edges, pieces->segment[2 * i], pieces->segment[2 * i + 1]);
        // a curve may end in a face that was left out
        if (edge >= 0) {
            s.bend[edge] = of_curve[pieces->curve[i]];
        }
    }
    *out = s;
    s = (curved_sides){0};

done:
    free(of_curve);
    curved_sides_free(&s);
    return st;
}

// an arc from a to b about a centre, the short way; the radius runs linearly between those of its
// ends
typedef struct arc {
    double centre[2], radius[2], from, angle;
} arc;

static arc arc_between(const double *centre, const double *a, const double *b)
{
    const double ax = a[0] - centre[0], ay = a[1] - centre[1];
    const double bx = b[0] - centre[0], by = b[1] - centre[1];
    return (arc){.centre = {centre[0], centre[1]},
                 .radius = {hypot(ax, ay), hypot(bx, by)},
                 .from = atan2(ay, ax),
                 .angle = atan2(ax * by - ay * bx, ax * bx + ay * by)};
}

// the point at t in [0, 1] of a side: on its arc, or on the straight line
static void side_point(const bend *side, const double *a, const double *b, double t, double *x)
{
    if (side->curve < 0 || !side->round) {
        x[0] = a[0] + (b[0] - a[0]) * t;
        x[1] = a[1] + (b[1] - a[1]) * t;
        return;
    }
    const arc c = arc_between(side->centre, a, b);
    const double r = c.radius[0] + (c.radius[1] - c.radius[0]) * t, angle = c.from + c.angle * t;
    x[0] = c.centre[0] + r * cos(angle);
    x[1] = c.centre[1] + r * sin(angle);
}

double curved_triangle_area(const plane_pieces *pieces, const curved_sides *s, int triangle)
{
    const int *corner = pieces->corner + 3 * (size_t)triangle;
    const double *x[3];
    for (int i = 0; i < 3; i++) {
        x[i] = pieces->xy + 2 * (size_t)corner[i];
    }
    double area =
        ((x[1][0] - x[0][0]) * (x[2][1] - x[0][1]) - (x[2][0] - x[0][0]) * (x[1][1] - x[0][1])) / 2;
    for (int i = 0; i < 3; i++) {
        const bend *side = &s->bend[s->edges.of[3 * triangle + i]];
        if (side->curve >= 0 && side->round) {
            const arc c = arc_between(side->centre, x[i], x[(i + 1) % 3]);
            area += c.radius[0] * c.radius[1] * (c.angle - sin(c.angle)) / 2;
        }
    }
    return area;
}

// Straight position plus the sides' bulges, each faded out towards the opposite corner by 4 La Lb /
// (1 - (Lb - La)^2): a polynomial of order p where the bulge is one, and of the size of its
// derivatives (Szabo and Babuska).
void curved_triangle_point(const plane_pieces *pieces, const curved_sides *s, int triangle,
                           const double bary[3], double *x)
{
    const int *corner = pieces->corner + 3 * (size_t)triangle;
    x[0] = x[1] = 0;
    for (int i = 0; i < 3; i++) {
        const double *a = pieces->xy + 2 * (size_t)corner[i];
        const double *b = pieces->xy + 2 * (size_t)corner[(i + 1) % 3];
        const bend *side = &s->bend[s->edges.of[3 * triangle + i]];
        const double la = bary[i], lb = bary[(i + 1) % 3], d = lb - la, t = (1 + d) / 2;
        const double fade = 4 * la * lb / (1 - d * d);
        double on[2];
        side_point(side, a, b, t, on);
        for (int k = 0; k < 2; k++) {
            x[k] += la * a[k] + fade * (on[k] - a[k] - (b[k] - a[k]) * t);
        }
    }
}

// Numbers of a mesh of order p: corners first, then p - 1 nodes of each edge from its smaller
// corner, then the insides.
typedef struct numbering {
    int p, ncorner, nedge;
    int *corner; // [pieces->nnode] -1 where unused
} numbering;

// node k = 1..p-1 on side `i` of a triangle, counted from corner i
static int edge_node(const numbering *w, const int *corner, const edge_list *e, int triangle, int i,
                     int k)
{
    const int edge = e->of[3 * triangle + i];
    const int from_low = corner[i] == e->end[edge][0] ? k : w->p - k;
    return w->ncorner + edge * (w->p - 1) + from_low - 1;
}

// lattice node (i, j) of a triangle; `inside` counts the nodes inside
static int lattice_node(const numbering *w, const int *corner, const edge_list *e, int triangle,
                        int i, int j, int inside)
{
    const int p = w->p, k = p - i - j;
    if (i == p || j == p || k == p) {
        return w->corner[corner[i == p ? 1 : j == p ? 2 : 0]];
    }
    if (j == 0) {
        return edge_node(w, corner, e, triangle, 0, i);
    }
    if (k == 0) {
        return edge_node(w, corner, e, triangle, 1, j);
    }
    if (i == 0) {
        return edge_node(w, corner, e, triangle, 2, p - j);
    }
    const int per = (p - 1) * (p - 2) / 2;
    return w->ncorner + w->nedge * (p - 1) + triangle * per + inside;
}

static void place_edges(const plane_pieces *pieces, const curved_sides *s, const numbering *w,
                        const element *e, double scale, mesh *m)
{
    for (int edge = 0; edge < w->nedge; edge++) {
        const double *a = pieces->xy + 2 * (size_t)s->edges.end[edge][0];
        const double *b = pieces->xy + 2 * (size_t)s->edges.end[edge][1];
        for (int k = 1; k < w->p; k++) {
            double *x = m->xyz + 3 * (size_t)(w->ncorner + edge * (w->p - 1) + k - 1);
            // on the side j = 0 the first reference coordinate is the Lobatto point itself
            side_point(&s->bend[edge], a, b, e->node[k][0], x);
            x[0] *= scale;
            x[1] *= scale;
        }
    }
}

static void place_triangle(const plane_pieces *pieces, const curved_sides *s, const numbering *w,
                           const element *e, int triangle, double scale, mesh *m)
{
    const int *corner = pieces->corner + 3 * (size_t)triangle;
    int *conn = m->block[0].conn + (size_t)triangle * (size_t)e->nnode;
    int n = 0, inside = 0;
    for (int j = 0; j <= w->p; j++) {
        for (int i = 0; i <= w->p - j; i++, n++) {
            conn[n] = lattice_node(w, corner, &s->edges, triangle, i, j, inside);
            if (i > 0 && j > 0 && i + j < w->p) {
                const double *at = e->node[n], bary[3] = {1 - at[0] - at[1], at[0], at[1]};
                double *x = m->xyz + 3 * (size_t)conn[n];
                curved_triangle_point(pieces, s, triangle, bary, x);
                x[0] *= scale;
                x[1] *= scale;
                inside++;
            }
        }
    }
}

status curved_mesh_make(const plane_pieces *pieces, const section_outline *o, const curved_sides *s,
                        int order, mesh *out)
{
    status st = OK;
    element e = {0};
    numbering w = {.p = order, .nedge = s->edges.nedge};
    mesh m = {0};
    const shape triangle = SHAPE_TRIANGLE;
    const int n = pieces->ntriangle;
    const double scale = o->size;

    TRY(element_make(SHAPE_TRIANGLE, order, &e));
    TRY(TAKE(w.corner, (size_t)pieces->nnode));
    memset(w.corner, 0xff, (size_t)pieces->nnode * sizeof *w.corner);
    for (int i = 0; i < 3 * n; i++) {
        int *at = &w.corner[pieces->corner[i]];
        *at = *at < 0 ? w.ncorner++ : *at;
    }
    const int nnode = w.ncorner + w.nedge * (order - 1) + n * (order - 1) * (order - 2) / 2;
    TRY(mesh_make(order, nnode, 1, &triangle, &n, &m));
    for (int i = 0; i < pieces->nnode; i++) {
        for (int d = 0; d < 2 && w.corner[i] >= 0; d++) {
            m.xyz[3 * (size_t)w.corner[i] + (size_t)d] =
                scale * pieces->xy[2 * (size_t)i + (size_t)d];
        }
    }
    place_edges(pieces, s, &w, &e, scale, &m);
    for (int k = 0; k < n; k++) {
        place_triangle(pieces, s, &w, &e, k, scale, &m);
        m.block[0].material[k] = o->items[pieces->owner[pieces->face[k]]].material;
    }
    *out = m;
    m = (mesh){0};

done:
    free(w.corner);
    mesh_free(&m);
    return st;
}
