// meshes/edges.c
#include "meshes/edges.h"

#include "base/memory.h"
#include "meshes/outline.h"

#include <stdbool.h>
#include <stdlib.h>

void edge_list_free(edge_list *e)
{
    free(e->of);
    free(e->end);
    free(e->count);
    *e = (edge_list){0};
}

typedef struct side {
    int low, high, at; // at: element * nside + side
} side;

static int side_order(const void *a, const void *b)
{
    const side *p = a, *q = b;
    if (p->low != q->low) {
        return p->low < q->low ? -1 : 1;
    }
    if (p->high != q->high) {
        return p->high < q->high ? -1 : 1;
    }
    return (p->at > q->at) - (p->at < q->at);
}

status edge_list_make(int nelem, int nside, const int *corner, edge_list *out)
{
    status st = OK;
    edge_list e = {.nside = nside};
    side *all = NULL;
    const int n = nelem * nside;

    TRY(TAKE(all, (size_t)n));
    TRY(TAKE(e.of, (size_t)n));
    TRY(TAKE(e.end, (size_t)n));
    TRY(TAKE(e.count, (size_t)n));
    for (int i = 0; i < n; i++) {
        const int a = corner[i], b = corner[i - i % nside + (i % nside + 1) % nside];
        all[i] = (side){.low = a < b ? a : b, .high = a < b ? b : a, .at = i};
    }
    qsort(all, (size_t)n, sizeof *all, side_order);
    for (int i = 0; i < n; i++) {
        const side *s = &all[i];
        if (s->low == s->high) { // no side: a triangle among quads
            e.of[s->at] = -1;
            continue;
        }
        if (i == 0 || s->low != s[-1].low || s->high != s[-1].high) {
            e.end[e.nedge][0] = s->low;
            e.end[e.nedge++][1] = s->high;
        }
        e.of[s->at] = e.nedge - 1;
        e.count[e.nedge - 1]++;
    }
    *out = e;
    e = (edge_list){0};

done:
    free(all);
    edge_list_free(&e);
    return st;
}

status mesh_corners(const mesh *m, int *nside, int **corner)
{
    status st = OK;
    const int p = m->order, mixed = m->nblock > 1;
    int *c = NULL, *to = NULL;
    *nside = mixed || m->block[0].shape == SHAPE_QUAD ? 4 : 3;
    TRY(TAKE(c, (size_t)mesh_element_count(m) * (size_t)*nside));
    to = c;
    for (int b = 0; b < m->nblock; b++) {
        const mesh_block *block = &m->block[b];
        const int last = block->per_elem - 1;
        const int triangle[] = {0, p, last, last}, quad[] = {0, p, last, last - p};
        const int *local = block->shape == SHAPE_QUAD ? quad : triangle;
        for (int e = 0; e < block->nelem; e++) {
            for (int k = 0; k < *nside; k++) {
                *to++ = block->conn[(size_t)e * (size_t)block->per_elem + (size_t)local[k]];
            }
        }
    }
    *corner = c;

done:
    return st;
}

static int root_of(int *parent, int i)
{
    while (parent[i] != i) {
        parent[i] = parent[parent[i]];
        i = parent[i];
    }
    return i;
}

// joins the elements that share an edge; first: [nedge] scratch
static void join(const edge_list *e, int nelem, int *first, int *parent)
{
    for (int i = 0; i < e->nedge; i++) {
        first[i] = -1;
    }
    for (int i = 0; i < nelem; i++) {
        parent[i] = i;
    }
    for (int i = 0; i < nelem * e->nside; i++) {
        const int edge = e->of[i], elem = i / e->nside;
        if (edge < 0) {
            continue;
        }
        if (first[edge] < 0) {
            first[edge] = elem;
        } else {
            const int a = root_of(parent, elem), b = root_of(parent, first[edge]);
            parent[a > b ? a : b] = a > b ? b : a;
        }
    }
}

// a part that does not hold element 0; touching: it shares a node with that part
static status parts_fail(const mesh *m, int apart, int nside, const int *corner, int *parent,
                         const int *owner, const section_outline *o)
{
    status st = OK;
    bool *first = NULL, touches = false;
    TRY(TAKE(first, (size_t)m->nnode));
    const int root = root_of(parent, apart);
    for (int i = 0; i < mesh_element_count(m) * nside; i++) {
        first[corner[i]] |= root_of(parent, i / nside) != root;
    }
    for (int i = 0; i < mesh_element_count(m) * nside; i++) {
        touches |= root_of(parent, i / nside) == root && first[corner[i]];
    }
    st = outline_fail(&o->items[owner[apart]], "%s",
                      touches ? "it touches the rest of the section in single points only"
                              : "a part of it does not touch the rest of the section");

done:
    free(first);
    return st;
}

status mesh_check_connected(const mesh *m, const int *owner, const section_outline *o)
{
    status st = OK;
    edge_list e = {0};
    int nside = 0, *corner = NULL, *first = NULL, *parent = NULL;
    const int nelem = mesh_element_count(m);

    TRY(mesh_corners(m, &nside, &corner));
    TRY(edge_list_make(nelem, nside, corner, &e));
    for (int i = 0; i < e.nedge; i++) {
        if (e.count[i] > 2) {
            TRY(status_fail(ERR_NUMERIC, "mesh: %d elements share one edge", e.count[i]));
        }
    }
    TRY(TAKE(first, (size_t)e.nedge));
    TRY(TAKE(parent, (size_t)nelem));
    join(&e, nelem, first, parent);
    for (int i = 0; i < nelem; i++) {
        if (root_of(parent, i) != 0) {
            TRY(parts_fail(m, i, nside, corner, parent, owner, o));
        }
    }

done:
    edge_list_free(&e);
    free(corner);
    free(first);
    free(parent);
    return st;
}
