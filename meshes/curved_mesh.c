// meshes/curved_mesh.c
#include "base/element.h"
#include "base/memory.h"
#include "meshes/curved.h"

#include <string.h>

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
        for (int k = 1; k < w->p; k++) {
            double *x = m->xyz + 3 * (size_t)(w->ncorner + edge * (w->p - 1) + k - 1);
            // on the side j = 0 the first reference coordinate is the Lobatto point itself
            curved_side_point(pieces, s, edge, e->node[k][0], x);
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
