#include "meshes/morph_marks.h"

#include "base/memory.h"
#include "meshes/edges.h"

#include <math.h>
#include <stdbool.h>

// nodes are found again on their curves, to well above the free mesher's own tolerance of 1e-7 of
// the section's size
static const double ON_CURVE = 1e-6;

// the nodes of the sides of an element; side k joins corners k and k + 1
typedef struct side_nodes {
    int node[4][ELEMENT_MAX_ORDER + 1];
} side_nodes;

// how far a reference point is from side k, 0 on it
static double off_side(shape s, int k, const double *x)
{
    if (s == SHAPE_QUAD) {
        const double off[4] = {x[1] + 1, 1 - x[0], 1 - x[1], x[0] + 1};
        return off[k];
    }
    const double off[3] = {x[1], 1 - x[0] - x[1], x[0]};
    return off[k];
}

static status find_side_nodes(const mesh *m, int nside, side_nodes *out)
{
    status st = OK;
    element e = {0};
    TRY(element_make(m->block[0].shape, m->order, &e));
    for (int k = 0; k < nside; k++) {
        int n = 0;
        for (int i = 0; i < e.nnode && n <= m->order; i++) {
            if (fabs(off_side(e.shape, k, e.node[i])) < 1e-12) { // exact numbers, to rounding
                out->node[k][n++] = i;
            }
        }
    }

done:
    return st;
}

typedef struct marker {
    const mesh *m;
    const shape_curves *c;
    double gap; // [m]
    side_nodes side;
    node_mark *of; // [nnode]
} marker;

// Which curve all nodes of a side lie on, the topmost one; -1: none.
static int curve_of_side(const marker *w, const int *node, int n, double *place)
{
    for (int curve = w->c->ncurve - 1; curve >= 0; curve--) {
        int on = 0;
        while (on < n && shape_curve_nearest(w->c, curve, w->m->xyz + 3 * (size_t)node[on],
                                             &place[on]) <= w->gap) {
            on++;
        }
        if (on == n) {
            return curve;
        }
    }
    return -1;
}

static void mark_node(node_mark *mark, int curve, double place)
{
    if (mark->curve[0] == curve || mark->curve[1] == curve) {
        return;
    }
    const int k = curve > mark->curve[0] ? 0 : 1;
    if (k == 0) {
        mark->curve[1] = mark->curve[0];
        mark->place[1] = mark->place[0];
    } else if (curve < mark->curve[1]) {
        return;
    }
    mark->curve[k] = curve;
    mark->place[k] = place;
}

static status mark_side(marker *w, int element, int side)
{
    const mesh_block *b = &w->m->block[0];
    const int n = w->m->order + 1;
    int node[ELEMENT_MAX_ORDER + 1];
    double place[ELEMENT_MAX_ORDER + 1];
    for (int i = 0; i < n; i++) {
        node[i] = b->conn[(size_t)element * (size_t)b->per_elem + (size_t)w->side.node[side][i]];
    }
    const int curve = curve_of_side(w, node, n, place);
    if (curve < 0) {
        const double *x = w->m->xyz + 3 * (size_t)node[0];
        return status_fail(ERR_NUMERIC,
                           "section: a border of its mesh near (%g, %g) mm lies on no shape's edge",
                           1e3 * x[0], 1e3 * x[1]);
    }
    for (int i = 0; i < n; i++) {
        mark_node(&w->of[node[i]], curve, place[i]);
    }
    return OK;
}

// whether what is on the two sides of an edge differs
static bool differ(const mesh_block *b, int i, int j)
{
    return b->material[i] != b->material[j] || (b->frame && b->frame[i] != b->frame[j]);
}

static status mark_sides(marker *w, const edge_list *edges)
{
    status st = OK;
    const mesh_block *b = &w->m->block[0];
    const int n = edges->nside;
    int *seen = NULL; // the element that an edge was met at, from 1
    TRY(TAKE(seen, (size_t)edges->nedge));
    for (int e = 0; e < b->nelem; e++) {
        for (int k = 0; k < n; k++) {
            const int edge = edges->of[n * e + k], other = seen[edge] - 1;
            seen[edge] = e + 1;
            if (edges->count[edge] == 1 || (other >= 0 && differ(b, e, other))) {
                TRY(mark_side(w, e, k));
            }
        }
    }

done:
    free(seen);
    return st;
}

status node_marks_make(const mesh *m, const shape_curves *c, double size, node_mark **mark,
                       int *nmark)
{
    status st = OK;
    edge_list edges = {0};
    int nside = 0, *corner = NULL, n = 0;
    marker w = {.m = m, .c = c, .gap = ON_CURVE * size};
    TRY(mesh_corners(m, &nside, &corner));
    TRY(edge_list_make(m->block[0].nelem, nside, corner, &edges));
    TRY(find_side_nodes(m, nside, &w.side));
    TRY(TAKE(w.of, (size_t)m->nnode));
    for (int i = 0; i < m->nnode; i++) {
        w.of[i] = (node_mark){.node = i, .curve = {-1, -1}};
    }
    TRY(mark_sides(&w, &edges));
    for (int i = 0; i < m->nnode; i++) {
        if (w.of[i].curve[0] >= 0) {
            w.of[n++] = w.of[i];
        }
    }
    *mark = w.of;
    *nmark = n;
    w.of = NULL;

done:
    free(corner);
    free(w.of);
    edge_list_free(&edges);
    return st;
}
