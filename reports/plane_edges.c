// reports/plane_edges.c
#include "reports/plane_edges.h"

#include "base/memory.h"

#include <stdlib.h>
#include <string.h>

// lattice indices of the nodes of side `side`, counter-clockwise (base/element.h)
static int side_nodes(shape shape, int p, int side, int *local)
{
    const int row = p + 1;
    for (int k = 0; k <= p; k++) {
        const int back = p - k;
        if (shape == SHAPE_QUAD) {
            const int at[4] = {k, p + row * k, back + row * p, row * back};
            local[k] = at[side];
        } else {
            // row j of a triangle begins after rows of p+1, p, ... nodes
            const int begin_k = k * row - k * (k - 1) / 2;
            const int begin_back = back * row - back * (back - 1) / 2;
            const int at[3] = {k, begin_k + (p - k), begin_back};
            local[k] = at[side];
        }
    }
    return p + 1;
}

static int side_count(shape shape)
{
    return shape == SHAPE_QUAD ? 4 : 3;
}

typedef struct side_key {
    int low, high, edge; // corner nodes in rising order
} side_key;

static int by_corners(const void *a, const void *b)
{
    const side_key *p = a, *q = b;
    const int u[3] = {p->low, p->high, p->edge}, v[3] = {q->low, q->high, q->edge};
    for (int i = 0; i < 3; i++) {
        if (u[i] != v[i]) {
            return u[i] < v[i] ? -1 : 1;
        }
    }
    return 0;
}

// two sides on the same corners are neighbours
static status find_neighbours(plane_edges *e)
{
    status st = OK;
    side_key *keys = NULL;
    const int p = e->mesh->order;

    TRY(TAKE(keys, (size_t)e->count));
    for (int i = 0; i < e->count; i++) {
        const int a = e->edge[i].node[0], b = e->edge[i].node[p];
        keys[i] = (side_key){a < b ? a : b, a < b ? b : a, i};
    }
    qsort(keys, (size_t)e->count, sizeof *keys, by_corners);
    for (int i = 0; i + 1 < e->count; i++) {
        if (keys[i].low == keys[i + 1].low && keys[i].high == keys[i + 1].high) {
            plane_edge *a = &e->edge[keys[i].edge], *b = &e->edge[keys[i + 1].edge];
            a->other = b->material;
            b->other = a->material;
        }
    }

done:
    free(keys);
    return st;
}

status plane_edges_make(const mesh *plane, plane_edges *out)
{
    status st = OK;
    plane_edges e = {.mesh = plane};

    TRY(element_make(SHAPE_LINE, plane->order, &e.line));
    int count = 0;
    for (int b = 0; b < plane->nblock; b++) {
        if (element_dim(plane->block[b].shape) != 2) {
            TRY(status_fail(ERR_BUG, "plane_edges: the mesh is not plane"));
        }
        count += side_count(plane->block[b].shape) * plane->block[b].nelem;
    }
    TRY(TAKE(e.edge, (size_t)count));
    for (int b = 0; b < plane->nblock; b++) {
        const mesh_block *block = &plane->block[b];
        for (int k = 0; k < block->nelem; k++) {
            for (int side = 0; side < side_count(block->shape); side++) {
                int local[ELEMENT_MAX_ORDER + 1];
                plane_edge *edge = &e.edge[e.count++];
                const int n = side_nodes(block->shape, plane->order, side, local);
                for (int i = 0; i < n; i++) {
                    edge->node[i] = block->conn[k * block->per_elem + local[i]];
                }
                edge->material = block->material[k];
                edge->other = -1;
            }
        }
    }
    TRY(find_neighbours(&e));
    *out = e;
    e = (plane_edges){0};

done:
    plane_edges_free(&e);
    return st;
}

void plane_edges_free(plane_edges *e)
{
    free(e->edge);
    e->edge = NULL;
    e->count = 0;
}

void plane_edge_point(const plane_edges *e, const plane_edge *edge, double t, double xy[2])
{
    double N[ELEMENT_MAX_ORDER + 1];
    element_basis(&e->line, &t, N, NULL);
    xy[0] = 0;
    xy[1] = 0;
    for (int i = 0; i < e->line.nnode; i++) {
        xy[0] += N[i] * e->mesh->xyz[3 * edge->node[i]];
        xy[1] += N[i] * e->mesh->xyz[3 * edge->node[i] + 1];
    }
}

// --- loops ---

typedef struct links {
    int *first; // [nnode] an edge that begins here, -1 for none
    int *next;  // [count] another one that begins at the same node
} links;

static int take_edge_at(links *l, int node)
{
    const int edge = l->first[node];
    if (edge >= 0) {
        l->first[node] = l->next[edge];
    }
    return edge;
}

status plane_loops_make(const plane_edges *e, int material, plane_loops *out)
{
    status st = OK;
    links l = {0};
    plane_loops loops = {0};
    const int p = e->mesh->order, nnode = e->mesh->nnode;
    int used = 0;

    TRY(TAKE(l.first, (size_t)nnode));
    TRY(TAKE(l.next, (size_t)e->count));
    TRY(TAKE(loops.start, (size_t)e->count + 1));
    TRY(TAKE(loops.order, (size_t)e->count));
    memset(l.first, -1, sizeof *l.first * (size_t)nnode);
    for (int i = e->count - 1; i >= 0; i--) {
        const plane_edge *edge = &e->edge[i];
        if (material == PLANE_WHOLE ? edge->other < 0
                                    : edge->material == material && edge->other != material) {
            l.next[i] = l.first[edge->node[0]];
            l.first[edge->node[0]] = i;
        }
    }
    for (int node = 0; node < nnode; node++) {
        for (int edge = take_edge_at(&l, node); edge >= 0; edge = take_edge_at(&l, node)) {
            for (; edge >= 0; edge = take_edge_at(&l, e->edge[edge].node[p])) {
                loops.order[used++] = edge;
            }
            loops.start[++loops.nloop] = used;
        }
    }
    *out = loops;
    loops = (plane_loops){0};

done:
    plane_loops_free(&loops);
    free(l.first);
    free(l.next);
    return st;
}

void plane_loops_free(plane_loops *l)
{
    free(l->start);
    free(l->order);
    *l = (plane_loops){0};
}

double plane_loop_area(const plane_edges *e, const plane_loops *l, int loop)
{
    double twice = 0;
    for (int k = l->start[loop]; k < l->start[loop + 1]; k++) {
        const int *node = e->edge[l->order[k]].node;
        for (int i = 0; i < e->mesh->order; i++) {
            const double *a = e->mesh->xyz + 3 * (size_t)node[i],
                         *b = e->mesh->xyz + 3 * (size_t)node[i + 1];
            twice += a[0] * b[1] - a[1] * b[0];
        }
    }
    return twice / 2;
}
