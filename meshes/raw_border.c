// meshes/raw_border.c
#include "base/memory.h"
#include "meshes/raw_check.h"

#include <math.h>

// Of the section's size, how near two nodes are one: files round to 8 digits at worst, and a gap of
// a real section is far wider. And the angle between edges that lie on one another [rad].
static const double SAME_PLACE = 1e-8, SAME_DIRECTION = 1e-6;

typedef long long number; // for printf

typedef struct border {
    const raw_mesh *r;
    int nedge;
    const int *edge; // [nedge][2]
} border;

double raw_extent(const raw_mesh *r)
{
    const double *a = r->xyz + 3 * (size_t)r->conn[0];
    double most = 0;
    for (int i = 0; i < r->nconn; i++) {
        const double *x = r->xyz + 3 * (size_t)r->conn[i];
        most = fmax(most, fmax(fabs(x[0] - a[0]), fabs(x[1] - a[1])));
    }
    return most;
}

// --- places

typedef struct place {
    int64_t x, y;
    int node;
} place;

static int place_order(const void *a, const void *b)
{
    const place *p = a, *q = b;
    if (p->x != q->x) {
        return p->x < q->x ? -1 : 1;
    }
    if (p->y != q->y) {
        return p->y < q->y ? -1 : 1;
    }
    return (p->node > q->node) - (p->node < q->node);
}

// Two nodes nearer than a cell are in the same one of the grids shifted by half a cell.
static bool find_coincident(const border *w, double cell, place *p, int found[2])
{
    const double *origin = w->r->xyz + 3 * (size_t)w->r->conn[0];
    for (int shift = 0; shift < 4; shift++) {
        for (int i = 0; i < 2 * w->nedge; i++) {
            const double *x = w->r->xyz + 3 * (size_t)w->edge[i];
            p[i] = (place){.x = llround((x[0] - origin[0]) / cell + 0.5 * (shift & 1)),
                           .y = llround((x[1] - origin[1]) / cell + 0.5 * (shift >> 1)),
                           .node = w->edge[i]};
        }
        qsort(p, 2 * (size_t)w->nedge, sizeof *p, place_order);
        for (int i = 1; i < 2 * w->nedge; i++) {
            if (p[i].x == p[i - 1].x && p[i].y == p[i - 1].y && p[i].node != p[i - 1].node) {
                found[0] = p[i - 1].node;
                found[1] = p[i].node;
                return true;
            }
        }
    }
    return false;
}

static status check_places(const border *w)
{
    status st = OK;
    place *p = NULL;
    int found[2];
    TRY(TAKE(p, 2 * (size_t)w->nedge));
    if (find_coincident(w, 2 * SAME_PLACE * raw_extent(w->r), p, found)) {
        const double *x = w->r->xyz + 3 * (size_t)found[0];
        TRY(input_file_fail(w->r->file, 0,
                            "nodes %lld and %lld are at the same place (%g, %g), so that the mesh "
                            "is cut open there: merge them (gmsh: Coherence Mesh)",
                            (number)w->r->node_id[found[0]], (number)w->r->node_id[found[1]], x[0],
                            x[1]));
    }

done:
    free(p);
    return st;
}

// --- directions

typedef struct spoke {
    int node, far;
    double angle;
} spoke;

static int spoke_order(const void *a, const void *b)
{
    const spoke *p = a, *q = b;
    if (p->node != q->node) {
        return p->node < q->node ? -1 : 1;
    }
    return (p->angle > q->angle) - (p->angle < q->angle);
}

static spoke spoke_of(const raw_mesh *r, int node, int far)
{
    const double *x = r->xyz + 3 * (size_t)node, *y = r->xyz + 3 * (size_t)far;
    return (spoke){.node = node, .far = far, .angle = atan2(y[1] - x[1], y[0] - x[0])};
}

static status spokes_differ(const raw_mesh *r, const spoke *a, const spoke *b, double between)
{
    if (between > SAME_DIRECTION) {
        return OK;
    }
    return input_file_fail(r->file, 0,
                           "the edges from node %lld to %lld and to %lld lie on one another, so "
                           "that the mesh is cut open there: a node hangs on a neighbour's edge",
                           (number)r->node_id[a->node], (number)r->node_id[a->far],
                           (number)r->node_id[b->far]);
}

// The edges of the border around each node, by their angle. A hole that closes to nothing there is
// a neighbour that was divided otherwise.
static status check_directions(const border *w)
{
    status st = OK;
    spoke *s = NULL;
    const int n = 2 * w->nedge;
    TRY(TAKE(s, (size_t)n));
    for (int i = 0; i < n; i++) {
        s[i] = spoke_of(w->r, w->edge[i], w->edge[i ^ 1]);
    }
    qsort(s, (size_t)n, sizeof *s, spoke_order);
    for (int i = 0, last = 0; i < n; i = last) {
        for (last = i + 1; last < n && s[last].node == s[i].node; last++) {
            TRY(spokes_differ(w->r, &s[last - 1], &s[last], s[last].angle - s[last - 1].angle));
        }
        if (last - i > 1) {
            const double turn = 8 * atan(1);
            TRY(spokes_differ(w->r, &s[last - 1], &s[i], s[i].angle + turn - s[last - 1].angle));
        }
    }

done:
    free(s);
    return st;
}

status raw_check_border(const raw_mesh *r, int nedge, const int *edge)
{
    status st = OK;
    const border w = {.r = r, .nedge = nedge, .edge = edge};
    TRY(check_places(&w));
    TRY(check_directions(&w));

done:
    return st;
}
