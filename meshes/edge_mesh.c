// meshes/edge_mesh.c
#include "meshes/edge_pieces.h"

#include "base/element.h"
#include "base/memory.h"
#include "meshes/sizing.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

static int material_of(const plane_pieces *pieces, const section_outline *o, int triangle)
{
    return o->items[pieces->owner[pieces->face[triangle]]].material;
}

typedef enum edge_kind { EDGE_NONE, EDGE_INTERFACE, EDGE_FREE } edge_kind;

static status find_kinds(const plane_pieces *pieces, const section_outline *o,
                         const edge_list *edges, edge_kind *kind)
{
    status st = OK;
    int *seen = NULL; // material + 1 of the first triangle at an edge
    TRY(TAKE(seen, (size_t)edges->nedge));
    for (int i = 0; i < edges->nedge; i++) {
        kind[i] = edges->count[i] == 1 ? EDGE_FREE : EDGE_NONE;
    }
    for (int i = 0; i < 3 * pieces->ntriangle; i++) {
        const int edge = edges->of[i], material = material_of(pieces, o, i / 3) + 1;
        if (seen[edge] > 0 && seen[edge] != material) {
            kind[edge] = EDGE_INTERFACE;
        }
        seen[edge] = material;
    }

done:
    free(seen);
    return st;
}

// shortest edge that leaves a free edge
static status thinnest_at_free(const plane_pieces *pieces, const edge_list *edges,
                               const edge_kind *kind, double *thinnest)
{
    status st = OK;
    bool *is_free = NULL;
    TRY(TAKE(is_free, (size_t)pieces->nnode));
    *thinnest = INFINITY;
    for (int i = 0; i < 2 * edges->nedge; i++) {
        is_free[edges->end[i / 2][i % 2]] |= kind[i / 2] == EDGE_FREE;
    }
    for (int i = 0; i < edges->nedge; i++) {
        const int *end = edges->end[i];
        const double *x = pieces->xy + 2 * (size_t)end[0], *y = pieces->xy + 2 * (size_t)end[1];
        if (kind[i] != EDGE_FREE && (is_free[end[0]] || is_free[end[1]])) {
            *thinnest = fmin(*thinnest, hypot(y[0] - x[0], y[1] - x[1]));
        }
    }

done:
    free(is_free);
    return st;
}

// thickness of the first layer along every edge; `pieces` are in units of the section's size
static status find_first(const plane_pieces *pieces, const section_outline *o,
                         const edge_list *edges, const mesh_options *options, double *first_of)
{
    status st = OK;
    edge_kind *kind = NULL;
    double thinnest = 0;
    TRY(TAKE(kind, (size_t)edges->nedge));
    TRY(find_kinds(pieces, o, edges, kind));
    TRY(thinnest_at_free(pieces, edges, kind, &thinnest));
    const double first = sizing_edge_first(options, 1, thinnest);
    for (int i = 0; i < edges->nedge; i++) {
        first_of[i] = kind[i] == EDGE_FREE        ? first
                      : kind[i] == EDGE_INTERFACE ? SIZING_INTERFACE * first
                                                  : 0;
    }

done:
    free(kind);
    return st;
}

// Numbers of nodes: the corners that are used, then p - 1 on each edge from its smaller corner,
// then the insides.
typedef struct node_plan {
    const plane_pieces *pieces;
    const curved_sides *sides;
    const edge_pieces *cut;
    double scale;
    int p, ncorner, next;
    edge_list edges; // of the pieces, all with four corners
    int *corner;     // [cut->ncorner] node, -1 where unused
    element shape[2];
    mesh m;
} node_plan;

// where a triangle's own shape has the reference coordinates (a, b) of a piece, quads on [0, 1]^2
static void place(const node_plan *w, const edge_piece *piece, double a, double b, int node)
{
    const double weight[2][4] = {{1 - a - b, a, b, 0},
                                 {(1 - a) * (1 - b), a * (1 - b), a * b, (1 - a) * b}};
    double bary[3] = {0}, *x = w->m.xyz + 3 * (size_t)node;
    for (int i = 0; i < piece->n; i++) {
        for (int k = 0; k < 3; k++) {
            bary[k] += weight[piece->n == 4][i] * piece->bary[i][k];
        }
    }
    curved_triangle_point(w->pieces, w->sides, piece->triangle, bary, x);
    x[0] *= w->scale;
    x[1] *= w->scale;
}

// Side of a piece's lattice that node (i, j) lies on and how far from its first corner, *k = 0 or p
// being corners; -1: inside.
static int side_of(int n, int p, int i, int j, int *k)
{
    const int far = n == 4 ? i == p : i + j == p; // on the side opposite to the first
    *k = j == 0 ? i : far ? j : n == 4 && j == p ? p - i : p - j;
    return j == 0 ? 0 : far ? 1 : n == 4 && j == p ? 2 : i == 0 ? 3 : -1;
}

// the number of lattice node (i, j), which is placed where it is met first
static int node_at(node_plan *w, int index, int i, int j, const double *reference)
{
    const edge_piece *piece = &w->cut->piece[index];
    const int p = w->p;
    const double a = piece->n == 4 ? (1 + reference[0]) / 2 : reference[0];
    const double b = piece->n == 4 ? (1 + reference[1]) / 2 : reference[1];
    int k = 0, node;
    const int side = side_of(piece->n, p, i, j, &k);
    if (side >= 0 && (k == 0 || k == p)) {
        // the third corner of a triangle is its fourth, too
        const int corner = piece->corner[k == 0 ? side : (side + 1) % 4];
        node = w->corner[corner];
        if (corner < w->pieces->nnode) {
            w->m.xyz[3 * (size_t)node] = w->scale * w->pieces->xy[2 * (size_t)corner];
            w->m.xyz[3 * (size_t)node + 1] = w->scale * w->pieces->xy[2 * (size_t)corner + 1];
            return node;
        }
    } else if (side >= 0) {
        const int edge = w->edges.of[4 * index + side];
        const int from_low = piece->corner[side] == w->edges.end[edge][0] ? k : p - k;
        node = w->ncorner + edge * (p - 1) + from_low - 1;
    } else {
        node = w->next++;
    }
    place(w, piece, a, b, node);
    return node;
}

static void place_piece(node_plan *w, int index, int *conn)
{
    const int n = w->cut->piece[index].n, p = w->p;
    const element *e = &w->shape[n == 4];
    for (int j = 0, at = 0; j <= p; j++) {
        for (int i = 0; i <= (n == 4 ? p : p - j); i++, at++) {
            conn[at] = node_at(w, index, i, j, e->node[at]);
        }
    }
}

static status make_empty(node_plan *w, const int nelem[2])
{
    status st = OK;
    const int p = w->p, n = w->cut->npiece;
    const shape shapes[2] = {SHAPE_TRIANGLE, SHAPE_QUAD};
    int *all = NULL;
    TRY(TAKE(all, 4 * (size_t)n));
    TRY(TAKE(w->corner, (size_t)w->cut->ncorner));
    memset(w->corner, 0xff, (size_t)w->cut->ncorner * sizeof *w->corner);
    for (int i = 0; i < 4 * n; i++) {
        all[i] = w->cut->piece[i / 4].corner[i % 4];
        int *at = &w->corner[all[i]];
        *at = *at < 0 ? w->ncorner++ : *at;
    }
    TRY(edge_list_make(n, 4, all, &w->edges));
    TRY(element_make(SHAPE_TRIANGLE, p, &w->shape[0]));
    TRY(element_make(SHAPE_QUAD, p, &w->shape[1]));
    w->next = w->ncorner + w->edges.nedge * (p - 1);
    const int inside = nelem[0] * (p - 1) * (p - 2) / 2 + nelem[1] * (p - 1) * (p - 1);
    const int nblock = nelem[1] > 0 ? 2 : 1;
    TRY(mesh_make(p, w->next + inside, nblock, shapes, nelem, &w->m));

done:
    free(all);
    return st;
}

static status make_nodes(node_plan *w, const section_outline *o, int **owner)
{
    status st = OK;
    int nelem[2] = {0}, done_of[2] = {0}, *shapes = NULL;
    const edge_pieces *cut = w->cut;
    for (int k = 0; k < cut->npiece; k++) {
        nelem[cut->piece[k].n == 4]++;
    }
    TRY(make_empty(w, nelem));
    TRY(TAKE(shapes, (size_t)cut->npiece));
    for (int k = 0; k < cut->npiece; k++) {
        const int b = cut->piece[k].n == 4, e = done_of[b]++;
        mesh_block *block = &w->m.block[b];
        const int of = w->pieces->owner[w->pieces->face[cut->piece[k].triangle]];
        place_piece(w, k, block->conn + (size_t)e * (size_t)block->per_elem);
        block->material[e] = o->items[of].material;
        shapes[b * nelem[0] + e] = of;
    }
    *owner = shapes;
    shapes = NULL;

done:
    free(shapes);
    return st;
}

status edge_mesh_make(const plane_pieces *pieces, const section_outline *o,
                      const curved_sides *sides, const mesh_options *options, mesh *out,
                      int **owner)
{
    status st = OK;
    edge_pieces cut = {0};
    node_plan w = {.pieces = pieces, .sides = sides, .cut = &cut, .scale = o->size};
    double *first_of = NULL;
    w.p = options->order;
    TRY(TAKE(first_of, (size_t)sides->edges.nedge));
    TRY(find_first(pieces, o, &sides->edges, options, first_of));
    TRY(edge_pieces_make(pieces, sides, first_of, &cut));
    if (cut.npiece > SECTION_MOST_ELEMENTS) {
        TRY(status_fail(ERR_INPUT, "mesh: its edge layers ask for more than %d elements",
                        SECTION_MOST_ELEMENTS));
    }
    TRY(make_nodes(&w, o, owner));
    *out = w.m;
    w.m = (mesh){0};

done:
    mesh_free(&w.m);
    free(first_of);
    free(w.corner);
    edge_list_free(&w.edges);
    edge_pieces_free(&cut);
    return st;
}
