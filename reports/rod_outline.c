// reports/rod_outline.c
#include "reports/rod_outline.h"

#include "base/memory.h"
#include "reports/plane_edges.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { AROUND = 40, LOOPS = 8, CUTS = 8, LEAST_PIECES = 12, CIRCLE = 40 };

bool rod_rest_is_known(const rod_result *rod)
{
    return rod->rest && vec3_norm((vec3){{rod->rest[0].R.a[0][2], rod->rest[0].R.a[1][2],
                                          rod->rest[0].R.a[2][2]}}) > 0.5;
}

void rod_outline_free(rod_outline *o)
{
    free(o->loop);
    free(o->point);
    free(o->ink);
    free(o->turn);
    *o = (rod_outline){0};
}

// --- loops

typedef struct edge_cuts {
    int stride; // of a loop of very many edges
    double step;
} edge_cuts;

static double edge_length(const plane_edges *e, const plane_edge *edge)
{
    const double *a = e->mesh->xyz + 3 * (size_t)edge->node[0];
    const double *b = e->mesh->xyz + 3 * (size_t)edge->node[e->line.order];
    return hypot(b[0] - a[0], b[1] - a[1]);
}

static int cuts_of(const plane_edges *e, const plane_edge *edge, const edge_cuts *cuts)
{
    const double n = cuts->stride > 1 ? 1 : round(edge_length(e, edge) / cuts->step);
    return !(n >= 1) ? 1 : n > CUTS ? CUTS : (int)n;
}

// small loops get as few pieces as they are small
static edge_cuts cuts_for(const plane_loops *l, int loop, double own, double around)
{
    const int n = l->start[loop + 1] - l->start[loop];
    const double part = around > 0 ? fmin(own / around, 1) : 1;
    return (edge_cuts){1 + n / (int)fmax(4 * AROUND * part, LEAST_PIECES), around / AROUND};
}

static double loop_length(const plane_edges *e, const plane_loops *l, int loop)
{
    double sum = 0;
    for (int k = l->start[loop]; k < l->start[loop + 1]; k++) {
        sum += edge_length(e, &e->edge[l->order[k]]);
    }
    return sum;
}

static void add_loop(rod_outline *o, const plane_edges *e, const plane_loops *l, int loop,
                     double around)
{
    const edge_cuts cuts = cuts_for(l, loop, loop_length(e, l, loop), around);
    int n = 0;
    for (int k = l->start[loop]; k < l->start[loop + 1]; k += cuts.stride) {
        const plane_edge *edge = &e->edge[l->order[k]];
        const int pieces = cuts_of(e, edge, &cuts);
        for (int i = 0; i < pieces; i++, n++) {
            plane_edge_point(e, edge, 2.0 * i / pieces - 1, o->point[o->npoint + n]);
            o->ink[o->npoint + n] = (unsigned char)(edge->material & 15);
        }
    }
    o->loop[o->nloop++] = n;
    o->npoint += n;
}

// the largest loops first: what is left off is small
static void rank(const plane_edges *e, const plane_loops *l, int *order)
{
    for (int i = 0; i < l->nloop; i++) {
        int k = i;
        for (; k > 0 && fabs(plane_loop_area(e, l, order[k - 1])) < fabs(plane_loop_area(e, l, i));
             k--) {
            order[k] = order[k - 1];
        }
        order[k] = i;
    }
}

static status from_mesh(const mesh *m, rod_outline *o)
{
    status st = OK;
    plane_edges edges = {0};
    plane_loops loops = {0};
    int *order = NULL;
    TRY(plane_edges_make(m, &edges));
    TRY(plane_loops_make(&edges, PLANE_WHOLE, &loops));
    TRY(TAKE(order, (size_t)loops.nloop));
    if (loops.nloop > 1000) {
        loops.nloop = 1000; // a sponge: which pores are drawn says nothing
    }
    rank(&edges, &loops, order);
    const int n = loops.nloop < LOOPS ? loops.nloop : LOOPS;
    TRY(TAKE(o->loop, (size_t)n));
    size_t room = 0;
    for (int i = 0; i < n; i++) {
        room += CUTS * (size_t)(loops.start[order[i] + 1] - loops.start[order[i]]);
    }
    TRY(TAKE(o->point, room));
    TRY(TAKE(o->ink, room));
    for (int i = 0; i < n; i++) {
        add_loop(o, &edges, &loops, order[i], loop_length(&edges, &loops, order[0]));
    }
    if (n < loops.nloop) {
        (void)snprintf(o->why, sizeof o->why, "Small holes of the section are not drawn.");
    }

done:
    plane_loops_free(&loops);
    plane_edges_free(&edges);
    free(order);
    return st;
}

static status circle(const run_result *r, rod_outline *o)
{
    status st = OK;
    const bool known = r->has_section && r->section.nstation > 0;
    const double area = known ? r->section.station[0].law.area : 0;
    const double radius = area > 0 ? sqrt(area / acos(-1.0)) : r->rod_length / 60;
    TRY(TAKE(o->loop, 1));
    TRY(TAKE(o->point, CIRCLE));
    TRY(TAKE(o->ink, CIRCLE));
    o->loop[0] = o->npoint = CIRCLE;
    o->nloop = 1;
    o->plain = true;
    for (int i = 0; i < CIRCLE; i++) {
        const double angle = 2 * acos(-1.0) * i / CIRCLE;
        o->point[i][0] = radius * cos(angle);
        o->point[i][1] = radius * sin(angle);
    }
    (void)snprintf(o->why, sizeof o->why, "The section is drawn as a full circle%s.",
                   area > 0 ? " of its area" : "");

done:
    return st;
}

// whether there is one, of places that are numbers
static bool is_drawable(const rod_outline *o)
{
    bool all = o->npoint > 0;
    for (int i = 0; i < o->npoint; i++) {
        all = all && isfinite(o->point[i][0]) && isfinite(o->point[i][1]);
    }
    return all;
}

static status shape_of(const run_result *r, rod_outline *o)
{
    status st = OK;
    TRY(r->has_section && r->section_mesh.nnode > 0 ? from_mesh(&r->section_mesh, o) : OK);
    if (!is_drawable(o)) {
        rod_outline_free(o);
        TRY(circle(r, o));
    }

done:
    return st;
}

// --- along the rod

static double turn_at(const law_along *a, double s)
{
    for (int p = 0; a->turn && p < a->npanel; p++) {
        for (int i = 0; i + 1 < a->nnode && s <= a->edge[p + 1] * (1 + 1e-12); i++) {
            const double s0 = law_along_node(a, p, i), s1 = law_along_node(a, p, i + 1);
            if (s <= s1 || i + 2 == a->nnode) {
                const double t = fmin(fmax((s - s0) / (s1 - s0), 0), 1);
                const double *turn = a->turn + p * a->nnode + i;
                return turn[0] + t * (turn[1] - turn[0]);
            }
        }
    }
    return a->turn && a->npanel > 0 ? a->turn[0] : 0;
}

// whether the section changes by more than its turn; a drawing does not tell less
static bool varies(const law_along *a)
{
    static const double seen = 1e-3;
    for (int i = 1; i < a->npanel * a->nnode; i++) {
        for (int k = 0; k < 6; k++) {
            const double first = a->law[0].K.a[k][k];
            if (fabs(a->law[i].K.a[k][k] - first) > seen * fabs(first)) {
                return true;
            }
        }
    }
    return false;
}

static bool turns(const law_along *a)
{
    static const double seen = 0.02; // [rad], of what a drawing shows
    for (int i = 1; a->turn && i < a->npanel * a->nnode; i++) {
        if (fabs(a->turn[i] - a->turn[0]) > seen) {
            return true;
        }
    }
    return false;
}

static void dress(const run_result *r, rod_outline *o)
{
    static const int inks = sizeof o->colour / sizeof *o->colour;
    o->nink = inks;
    o->plain = o->plain || r->nmaterial > inks;
    for (int m = 0; m < inks; m++) {
        o->colour[m] = o->plain ? NO_MATERIAL : colour_material(m);
    }
    for (int i = 0; i < o->npoint; i++) {
        o->used[o->ink[i]] = o->ink[i] < r->nmaterial;
        o->radius = fmax(o->radius, hypot(o->point[i][0], o->point[i][1]));
    }
}

status rod_outline_make(const run_result *r, int nring, const double *s, rod_outline *out)
{
    status st = OK;
    rod_outline o = {0};
    const law_along *along = &r->section.along;
    const bool law = r->has_section && along->law && r->section.nstation > 0;
    TRY(shape_of(r, &o));
    TRY(TAKE(o.turn, (size_t)nring));
    const double first = law ? turn_at(along, r->section.station[0].s) : 0;
    for (int k = 0; law && k < nring; k++) {
        const double turn = turn_at(along, s[k]) - first;
        o.plain = o.plain || !isfinite(turn);
        o.turn[k] = isfinite(turn) ? turn : 0;
    }
    if (law && varies(along) && !o.plain) {
        // a pattern that turns is seen turning, whatever else becomes of it
        o.plain = !turns(along);
        (void)snprintf(o.why, sizeof o.why,
                       o.plain ? "The section changes along the rod; it is drawn as at s = %s mm "
                                 "all along, in one colour."
                               : "The section's pattern turns and changes along the rod; it is "
                                 "drawn as at s = %s mm all along, turned as it turns.",
                       number_short(1e3 * r->section.station[0].s, 5).text);
    }
    dress(r, &o);
    *out = o;
    o = (rod_outline){0};

done:
    rod_outline_free(&o);
    return st;
}
