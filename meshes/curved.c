// meshes/curved.c
#include "meshes/curved.h"

#include "base/element.h"
#include "base/memory.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#define PI 3.14159265358979323846

// a curve is found again to well above OpenCASCADE's own tolerance of 1e-7
static const double OWN_CURVE = 1e-6;
// below this part of the chord a curve is straight to rounding
static const double STRAIGHT = 1e-9;

void curved_sides_free(curved_sides *s)
{
    edge_list_free(&s->edges);
    free(s->bend);
    free(s->carrier);
    *s = (curved_sides){0};
}

static bool bends(const double *probe, double length)
{
    const double *end = probe + 2 * (CURVE_PROBES - 1);
    const double dx = end[0] - probe[0], dy = end[1] - probe[1], chord = hypot(dx, dy);
    double off = 0;
    for (int i = 1; i < CURVE_PROBES - 1; i++) {
        const double *x = probe + 2 * i;
        off = fmax(off, fabs(dx * (x[1] - probe[1]) - dy * (x[0] - probe[0])));
    }
    return chord < length / 2 || off > STRAIGHT * chord * chord;
}

// the outlines' curves, in units of the section's size
static status collect_carriers(const section_outline *o, curved_sides *s)
{
    status st = OK;
    size_t most = 0;
    for (int k = 0; k < o->count; k++) {
        most +=
            o->items[k].kind == KIND_LOOPS ? (size_t)o->items[k].loop_start[o->items[k].nloop] : 2;
    }
    TRY(TAKE(s->carrier, most));
    for (int k = 0; k < o->count; k++) {
        const outline *p = &o->items[k];
        for (int i = 0; p->kind == KIND_LOOPS && i < p->loop_start[p->nloop]; i++) {
            if (p->piece[i].kind != CARRIER_LINE) {
                s->carrier[s->ncarrier++] = carrier_scaled(&p->piece[i], 1 / o->size);
            }
        }
        const double radius[2] = {p->nloop > 0 ? 0 : p->outer, p->nloop > 0 ? 0 : p->inner};
        for (int i = 0; i < 2; i++) {
            if (radius[i] > 0) {
                const carrier c = carrier_arc(p->centre, radius[i], radius[i], 0, 0, 1);
                s->carrier[s->ncarrier++] = carrier_scaled(&c, 1 / o->size);
            }
        }
    }

done:
    return st;
}

// far from all of the curve: most of them, without a look at it
static bool is_far(const carrier *c, const double *x)
{
    for (int k = 0; k < 2; k++) {
        double low = x[k], high = x[k];
        if (c->kind == CARRIER_ELLIPSE) {
            const double reach = fabs(c->p[1][k]) + fabs(c->p[2][k]);
            low = c->p[0][k] - reach;
            high = c->p[0][k] + reach;
        } else if (c->kind == CARRIER_CUBIC) {
            low = fmin(fmin(c->p[0][k], c->p[1][k]), fmin(c->p[2][k], c->p[3][k]));
            high = fmax(fmax(c->p[0][k], c->p[1][k]), fmax(c->p[2][k], c->p[3][k]));
        }
        if (x[k] < low - OWN_CURVE || x[k] > high + OWN_CURVE) {
            return true;
        }
    }
    return false;
}

// largest distance of the points from a carrier, or more than `enough`
static double distance_of(const double *probe, const carrier *c, double enough)
{
    double off = is_far(c, probe + 2 * (CURVE_PROBES / 2)) ? enough : 0, t;
    // the middle first: it tells most of them apart
    for (int i = 0; i < CURVE_PROBES && off < enough; i++) {
        const int k = (i + CURVE_PROBES / 2) % CURVE_PROBES;
        off = fmax(off, carrier_distance(c, probe + 2 * (size_t)k, &t));
    }
    return off;
}

// the carrier on which the points lie best
static status find_carrier(const double *probe, const curved_sides *s, int *on)
{
    double best = OWN_CURVE;
    *on = -1;
    for (int i = 0; i < s->ncarrier; i++) {
        const double off = distance_of(probe, &s->carrier[i], best);
        if (off < best) {
            best = off;
            *on = i;
        }
    }
    return *on >= 0 ? OK
                    : status_fail(ERR_NUMERIC, "the free mesher bent a curve that no shape drew");
}

// the parameters of an edge's ends; on an ellipse the short way
static void find_ends(const plane_pieces *p, const curved_sides *s, int edge, bend *b)
{
    const carrier *c = &s->carrier[b->on];
    for (int i = 0; i < 2; i++) {
        (void)carrier_distance(c, p->xy + 2 * (size_t)s->edges.end[edge][i], &b->at[i]);
    }
    if (c->kind == CARRIER_ELLIPSE) {
        b->at[1] = b->at[0] + remainder(b->at[1] - b->at[0], 2 * PI);
    }
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
    int *on = NULL; // carrier of each curve

    TRY(edge_list_make(pieces->ntriangle, 3, pieces->corner, &s.edges));
    TRY(TAKE(s.bend, (size_t)s.edges.nedge));
    TRY(TAKE(on, (size_t)pieces->ncurve));
    TRY(collect_carriers(o, &s));
    for (int i = 0; i < s.edges.nedge; i++) {
        s.bend[i] = (bend){.curve = -1, .on = -1};
    }
    for (int i = 0; i < pieces->ncurve; i++) {
        const double *probe = pieces->probe + 2 * CURVE_PROBES * (size_t)i;
        on[i] = -1;
        if (bends(probe, pieces->length[i])) {
            TRY(find_carrier(probe, &s, &on[i]));
        }
    }
    for (int i = 0; i < pieces->nsegment; i++) {
        const int edge = find_edge(&s.edges, pieces->segment[2 * i], pieces->segment[2 * i + 1]);
        // a curve may end in a face that was left out
        if (edge >= 0) {
            bend *b = &s.bend[edge];
            b->curve = pieces->curve[i];
            b->on = on[b->curve];
            if (b->on >= 0) {
                find_ends(pieces, &s, edge, b);
            }
        }
    }
    *out = s;
    s = (curved_sides){0};

done:
    free(on);
    curved_sides_free(&s);
    return st;
}

// A side from node a to node b. What its ends miss the carrier by is spread linearly, so that it
// begins and ends in its nodes.
typedef struct way {
    const carrier *on; // NULL: straight
    double from, to;
    const double *a, *b;
    double miss[2][2];
} way;

static way way_along(const plane_pieces *pieces, const curved_sides *s, int edge, int first)
{
    const bend *b = &s->bend[edge];
    const int *end = s->edges.end[edge], back = end[0] != first;
    way w = {.a = pieces->xy + 2 * (size_t)end[back], .b = pieces->xy + 2 * (size_t)end[!back]};
    if (b->on >= 0) {
        w.on = &s->carrier[b->on];
        w.from = b->at[back];
        w.to = b->at[!back];
        carrier_point(w.on, w.from, w.miss[0]);
        carrier_point(w.on, w.to, w.miss[1]);
        for (int k = 0; k < 2; k++) {
            w.miss[0][k] = w.a[k] - w.miss[0][k];
            w.miss[1][k] = w.b[k] - w.miss[1][k];
        }
    }
    return w;
}

// the point at t in [0, 1] of a side
static void way_point(const way *w, double t, double *x)
{
    if (!w->on) {
        x[0] = w->a[0] + (w->b[0] - w->a[0]) * t;
        x[1] = w->a[1] + (w->b[1] - w->a[1]) * t;
        return;
    }
    carrier_point(w->on, w->from + (w->to - w->from) * t, x);
    for (int k = 0; k < 2; k++) {
        x[k] += w->miss[0][k] * (1 - t) + w->miss[1][k] * t;
    }
}

// the area between the side and its chord, positive where the side bulges to the right
static double way_area(const way *w)
{
    enum { POINTS = 12 }; // exact to rounding for arcs below a quarter turn
    double t[POINTS], weight[POINTS], sum = 0;
    gauss_legendre(POINTS, t, weight);
    for (int q = 0; q < POINTS; q++) {
        double x[2], slope[2];
        way_point(w, (1 + t[q]) / 2, x);
        carrier_slope(w->on, w->from + (w->to - w->from) * (1 + t[q]) / 2, slope);
        for (int k = 0; k < 2; k++) {
            slope[k] = slope[k] * (w->to - w->from) + w->miss[1][k] - w->miss[0][k];
        }
        sum += weight[q] / 4 * ((x[0] - w->a[0]) * slope[1] - (x[1] - w->a[1]) * slope[0]);
    }
    return sum;
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
        const way w = way_along(pieces, s, s->edges.of[3 * triangle + i], corner[i]);
        area += w.on ? way_area(&w) : 0;
    }
    return area;
}

void curved_side_point(const plane_pieces *pieces, const curved_sides *s, int edge, double t,
                       double *x)
{
    const way w = way_along(pieces, s, edge, s->edges.end[edge][0]);
    way_point(&w, t, x);
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
        const way w = way_along(pieces, s, s->edges.of[3 * triangle + i], corner[i]);
        const double la = bary[i], lb = bary[(i + 1) % 3], d = lb - la, t = (1 + d) / 2;
        const double fade = 4 * la * lb / (1 - d * d);
        double on[2];
        way_point(&w, t, on);
        for (int k = 0; k < 2; k++) {
            x[k] += la * w.a[k] + fade * (on[k] - w.a[k] - (w.b[k] - w.a[k]) * t);
        }
    }
}
