// meshes/edge_pieces.c
#include "meshes/edge_pieces.h"

#include "base/memory.h"
#include "meshes/sizing.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

void edge_pieces_free(edge_pieces *e)
{
    free(e->piece);
    *e = (edge_pieces){0};
}

// A place in a triangle.
typedef struct spot {
    int corner;
    double bary[3];
} spot;

// From a node away from the edges that ask for layers: spot[0] is the node, spot[n] the end of the
// outermost layer.
typedef struct chain {
    int n;
    spot spot[EDGE_MOST_LAYERS + 1];
} chain;

typedef struct cutting {
    const plane_pieces *pieces;
    const curved_sides *sides;
    const double *first_of;
    double *node_first; // [nnode] the least of the edges there
    int *node_layers;   // [nnode]
    int *cut;           // [nedge][2] first corner of the cuts next to either end
    edge_pieces out;
    // the triangle at hand
    int triangle;
    const int *node, *edge; // [3]
} cutting;

static void put_piece(cutting *w, int n, const spot *const *at)
{
    const int index = w->out.npiece++;
    if (!w->out.piece) {
        return; // counted only
    }
    edge_piece *p = &w->out.piece[index];
    p->triangle = w->triangle;
    p->n = n;
    for (int i = 0; i < 4; i++) {
        const spot *from = at[i < n ? i : n - 1];
        p->corner[i] = from->corner;
        for (int k = 0; k < 3; k++) {
            p->bary[i][k] = from->bary[k];
        }
    }
}

static void put_triangle(cutting *w, const spot *a, const spot *b, const spot *c)
{
    put_piece(w, 3, (const spot *const[]){a, b, c});
}

static void put_quad(cutting *w, const spot *a, const spot *b, const spot *c, const spot *d)
{
    put_piece(w, 4, (const spot *const[]){a, b, c, d});
}

// Where layer k = 1, 2, ... from corner i ends, as a part of a length.
static double cut_at(const cutting *w, int i, int k, double length)
{
    return w->node_first[w->node[i]] * pow(SIZING_GROWTH, k - 1) / length;
}

static double edge_length(const cutting *w, int edge)
{
    const int *end = w->sides->edges.end[edge];
    const double *x = w->pieces->xy + 2 * (size_t)end[0], *y = w->pieces->xy + 2 * (size_t)end[1];
    return hypot(y[0] - x[0], y[1] - x[1]);
}

// the shorter of the two sides that meet in corner i: what an inner chain's layers are parts of
static double reach_at(const cutting *w, int i)
{
    return fmin(edge_length(w, w->edge[i]), edge_length(w, w->edge[(i + 2) % 3]));
}

static chain chain_begin(const cutting *w, int i)
{
    chain c = {.n = w->node_layers[w->node[i]]};
    c.spot[0].corner = w->node[i];
    c.spot[0].bary[i] = 1;
    return c;
}

// along the side from corner i to corner `to`, which asks for no layers itself
static chain chain_along(const cutting *w, int i, int to)
{
    chain c = chain_begin(w, i);
    const int edge = w->edge[(i + 1) % 3 == to ? i : to];
    const int back = w->sides->edges.end[edge][0] != w->node[i];
    for (int k = 1; k <= c.n; k++) {
        const double t = cut_at(w, i, k, edge_length(w, edge));
        c.spot[k].corner = w->cut[2 * edge + back] + k - 1;
        c.spot[k].bary[i] = 1 - t;
        c.spot[k].bary[to] = t;
    }
    return c;
}

// between two sides that both ask for layers
static chain chain_inside(cutting *w, int i)
{
    chain c = chain_begin(w, i);
    for (int k = 1; k <= c.n; k++) {
        const double t = cut_at(w, i, k, reach_at(w, i));
        c.spot[k].corner = w->out.ncorner++;
        c.spot[k].bary[i] = 1 - 2 * t;
        c.spot[k].bary[(i + 1) % 3] = c.spot[k].bary[(i + 2) % 3] = t;
    }
    return c;
}

// Layers along the side from a's node to b's. The longer chain's innermost layers end in the other
// node.
static void put_strip(cutting *w, const chain *a, const chain *b)
{
    int i = 0, j = 0;
    while (i < a->n || j < b->n) {
        const int left = (a->n - i) - (b->n - j);
        if (left > 0) {
            put_triangle(w, &a->spot[i], &b->spot[j], &a->spot[i + 1]);
        } else if (left < 0) {
            put_triangle(w, &a->spot[i], &b->spot[j], &b->spot[j + 1]);
        } else {
            put_quad(w, &a->spot[i], &b->spot[j], &b->spot[j + 1], &a->spot[i + 1]);
        }
        i += left >= 0;
        j += left <= 0;
    }
}

// layers around a node from which no side with layers starts: a along the next side, b along the
// one before
static void put_tip(cutting *w, const chain *a, const chain *b)
{
    put_triangle(w, &a->spot[0], &a->spot[1], &b->spot[1]);
    for (int k = 1; k < a->n; k++) {
        put_quad(w, &a->spot[k], &a->spot[k + 1], &b->spot[k + 1], &b->spot[k]);
    }
}

// What the layers leave: corners counter-clockwise, `tip` tells which of the triangle's corners
// gave two. Mirror images are cut alike.
static void put_middle(cutting *w, int n, const spot *at, const bool tip[3])
{
    if (n == 3) {
        put_triangle(w, &at[0], &at[1], &at[2]);
    } else if (n == 4) {
        put_quad(w, &at[0], &at[1], &at[2], &at[3]);
    } else if (n == 5) {
        // its single corner apart
        const int s = !tip[0] ? 0 : !tip[1] ? 2 : 4;
        const spot *p[5];
        for (int k = 0; k < 5; k++) {
            p[k] = &at[(s + k) % 5];
        }
        put_triangle(w, p[0], p[1], p[4]);
        put_quad(w, p[1], p[2], p[3], p[4]);
    } else {
        const spot centre = {w->out.ncorner++, {1.0 / 3, 1.0 / 3, 1.0 / 3}};
        for (int k = 0; k < n; k++) {
            put_triangle(w, &centre, &at[k], &at[(k + 1) % n]);
        }
    }
}

static void cut_triangle(cutting *w, int triangle)
{
    chain next[3], before[3]; // at corner i: the one along side i, and that along the side before
    spot middle[6];
    bool tip[3];
    int n = 0;
    w->triangle = triangle;
    w->node = w->pieces->corner + 3 * (size_t)triangle;
    w->edge = w->sides->edges.of + 3 * (size_t)triangle;
    for (int i = 0; i < 3; i++) {
        const int to = (i + 1) % 3, from = (i + 2) % 3;
        const bool on = w->first_of[w->edge[i]] > 0, came = w->first_of[w->edge[from]] > 0;
        tip[i] = !on && !came && w->node_layers[w->node[i]] > 0;
        if (on && came) {
            next[i] = before[i] = chain_inside(w, i);
        } else if (on || came) {
            next[i] = before[i] = chain_along(w, i, on ? from : to);
        } else {
            next[i] = chain_along(w, i, to);
            before[i] = chain_along(w, i, from);
        }
        if (tip[i]) {
            middle[n++] = before[i].spot[before[i].n];
            put_tip(w, &next[i], &before[i]);
        }
        middle[n++] = next[i].spot[next[i].n];
    }
    for (int i = 0; i < 3; i++) {
        if (w->first_of[w->edge[i]] > 0) {
            put_strip(w, &next[i], &before[(i + 1) % 3]);
        }
    }
    put_middle(w, n, middle, tip);
}

// Layers may take this part of an edge from either end.
static const double MOST_OF_AN_EDGE = 0.25;

// As many layers at each node as the shortest edge there has room for.
static status count_layers(cutting *w)
{
    status st = OK;
    const edge_list *e = &w->sides->edges;
    double *reach = NULL; // shortest edge at each node
    TRY(TAKE(reach, (size_t)w->pieces->nnode));
    for (int i = 0; i < 2 * e->nedge; i++) {
        const int node = e->end[i / 2][i % 2];
        const double length = edge_length(w, i / 2), first = w->first_of[i / 2];
        double *least = &w->node_first[node];
        reach[node] = reach[node] > 0 ? fmin(reach[node], length) : length;
        *least = first > 0 && (*least == 0 || first < *least) ? first : *least;
    }
    for (int i = 0; i < w->pieces->nnode; i++) {
        const double room = MOST_OF_AN_EDGE * reach[i] / w->node_first[i];
        if (w->node_first[i] > 0 && room >= 1) {
            const double n = 1 + floor(log(room) / log(SIZING_GROWTH));
            w->node_layers[i] = (int)fmin(n, EDGE_MOST_LAYERS);
        }
    }

done:
    free(reach);
    return st;
}

// numbers for the cuts of edges that have no layers themselves
static void number_cuts(cutting *w)
{
    const edge_list *e = &w->sides->edges;
    w->out.ncorner = w->pieces->nnode;
    for (int i = 0; i < e->nedge; i++) {
        for (int k = 0; k < 2 && !(w->first_of[i] > 0); k++) {
            w->cut[2 * i + k] = w->out.ncorner;
            w->out.ncorner += w->node_layers[e->end[i][k]];
        }
    }
}

static void cut_all(cutting *w)
{
    w->out.npiece = 0;
    number_cuts(w);
    for (int k = 0; k < w->pieces->ntriangle; k++) {
        cut_triangle(w, k);
    }
}

status edge_pieces_make(const plane_pieces *pieces, const curved_sides *sides,
                        const double *first_of, edge_pieces *out)
{
    status st = OK;
    cutting w = {.pieces = pieces, .sides = sides, .first_of = first_of};
    TRY(TAKE(w.node_first, (size_t)pieces->nnode));
    TRY(TAKE(w.node_layers, (size_t)pieces->nnode));
    TRY(TAKE(w.cut, 2 * (size_t)sides->edges.nedge));
    TRY(count_layers(&w));
    cut_all(&w);
    TRY(TAKE(w.out.piece, (size_t)w.out.npiece));
    cut_all(&w);
    *out = w.out;
    w.out = (edge_pieces){0};

done:
    free(w.node_first);
    free(w.node_layers);
    free(w.cut);
    edge_pieces_free(&w.out);
    return st;
}
